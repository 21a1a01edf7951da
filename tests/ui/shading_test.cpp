// The choice of shading: the window shows, but for rounding, what `render --shade` writes, and F12 writes that.
#include <gtest/gtest.h>

#include <cstdlib>

#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

class ShadedWindow : public Editing {
protected:
    Picture rendered_so(const std::string& mode, const std::string& size, const std::string& samples) {
        const Outcome outcome = run({"render", scene_, "--backend", "cpu", "--shade", mode, "-s", size, "--samples", samples, "-o",
                                     folder_.path("expected.png")});
        EXPECT_EQ(outcome.status, 0) << outcome;
        return decode_png(folder_.read("expected.png"));
    }

    // How far any byte of the window's picture at rest is from `render`'s.
    int distance_to(const std::string& mode, int samples) {
        take_marks_away();
        const Json& size = window_.wait_for("samples", samples).at("picture_size");
        const Picture expected = rendered_so(mode, std::to_string(size[0].get<int>()) + "x" + std::to_string(size[1].get<int>()),
                                             std::to_string(samples));
        const Picture found = window_.picture();
        if (found.bytes.size() != expected.bytes.size()) return 255;
        int worst = 0;
        for (std::size_t i = 0; i < found.bytes.size(); ++i) {
            worst = std::max(worst,
                             std::abs(static_cast<unsigned char>(found.bytes[i]) - static_cast<unsigned char>(expected.bytes[i])));
        }
        return worst;
    }
};

}  // namespace

TEST_F(ShadedWindow, ShowsAndExportsWhatRenderMakes) {
    EXPECT_EQ(distance_to("flat", 1), 0);
    window_.click_widget("menu View");
    window_.click_widget("menu Shading");
    window_.click_widget("item Headlight");
    window_.wait_for("shading", "headlight");
    EXPECT_LE(distance_to("headlight", 1), 1);
    window_.key("alt+4");
    EXPECT_LE(distance_to("headlight", 4), 1);
    window_.key("F12");
    announced(window_, "scene.png");
    EXPECT_EQ(decode_png(folder_.read("scene.png")), rendered_so("headlight", "1000x1000", "4"));
    window_.key("alt+1");
    for (const auto& [key, mode] : {std::pair{"ctrl+3", "normal"}, {"ctrl+4", "depth"}, {"ctrl+5", "id"}, {"ctrl+1", "flat"}}) {
        window_.key(key);
        window_.wait_for("shading", mode);
        EXPECT_LE(distance_to(mode, 1), 1) << mode;
    }
}

}  // namespace sphereview::test

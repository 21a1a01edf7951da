// Full-size pictures: the backends agree byte for byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "formats/sphere_data.hpp"
#include "oracle/backends.hpp"
#include "support/trials.hpp"

namespace sphereview::oracle {

namespace {

constexpr int side = test::is_sanitized ? 300 : 1000;

Trials full_size_trials() {
    Trials trials;
    Random random(seed());
    for (const int count : {3, 40, 200}) {
        Trial trial{std::to_string(count) + " spheres, SPHEREVIEW_SEED=" + std::to_string(seed()), {}, {side, side}};
        for (int i = 0; i < count; ++i) {
            const double z = random.between(150.0, 1500.0);
            const double x = random.between(-0.5, 0.5) * z;
            const double y = random.between(-0.5, 0.5) * z;
            const double size = random.between(0.3, 1.3) * z / std::sqrt(count);
            const auto byte = [&] { return static_cast<std::uint8_t>(random.whole(0, 255)); };
            const Color color{byte(), byte(), byte()};
            trial.scene.spheres.push_back({{x, y, z}, 0.5 * size, color});
        }
        trials.push_back(trial);
    }
    Trial wide = trials[1];
    wide.size = {side * 6 / 5 + 1, side * 7 / 10 - 1};
    wide.scene.background = {{255, 255, 255}, true};
    wide.scene.camera = random_camera(random, 100.0);
    trials.push_back(wide);
    Trial near = near_miss_trial(5);
    near.size = {side - 1, side / 2};
    trials.push_back(near);
    return trials;
}

TEST(FullSize, backends_agree_byte_for_byte) {
    const Trials trials = full_size_trials();
    std::vector<Image> first;
    for (const Backend backend : tested_backends()) {
        OpenBackend open = opened(backend);
        for (std::size_t i = 0; i < trials.size(); ++i) {
            Image image = flat_picture(open, trials[i].scene, trials[i].size);
            if (first.size() <= i) {
                first.push_back(std::move(image));
            } else {
                EXPECT_TRUE(image.width() == first[i].width() && image.height() == first[i].height() &&
                            std::ranges::equal(image.bytes(), first[i].bytes()))
                    << trials[i].name << ": " << open.description << '\n'
                    << write_toml(trials[i].scene).substr(0, 2000);
            }
        }
    }
}

}  // namespace

}  // namespace sphereview::oracle

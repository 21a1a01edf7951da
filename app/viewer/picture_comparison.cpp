#include "viewer/picture_comparison.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/compare_words.hpp"
#include "app/failure.hpp"
#include "base/path.hpp"
#include "base/text.hpp"
#include "exact/explain.hpp"
#include "image/picture_file.hpp"
#include "mistakes/comparer.hpp"
#include "mistakes/diagnosis.hpp"
#include "viewer/scene_file.hpp"

namespace sphereview {

namespace {

ComparisonWords in_words(const Diagnosis& diagnosis, const Scene& scene, const std::string& path, PictureSize size) {
    ComparisonWords words{.picture = text_from(path_from(path).filename()), .size = size};
    const auto count = [](std::int64_t pixels) { return in_groups(static_cast<std::uint64_t>(pixels)); };
    if (diagnosis.different == 0) {
        words.counts = "Equal to the right picture: all " + count(diagnosis.pixels) + " pixels.";
        return words;
    }
    words.counts = count(diagnosis.different) + " of " + count(diagnosis.pixels) + " pixels differ from the right picture.";
    words.verdict = verdict_in_words(diagnosis);
    for (const MistakeShare& share : diagnosis.shares) words.shares.push_back({share.words, share.pixels, share.mark});
    for (const DifferingPixel& example : diagnosis.examples) {
        words.examples.push_back({example.pixel, in_words(scene, example)});
    }
    return words;
}

// What a comparison was made of, to say something of any of its pixels.
class Compared {
public:
    // right: the numbers, row by row. background_found: that the likeliest mistake has instead of the right one.
    Compared(std::shared_ptr<const Scene> scene, std::shared_ptr<const Image> found, const Background& background,
             std::vector<std::int32_t> right, std::optional<Color> background_found)
        : scene_(std::move(scene)),
          found_(std::move(found)),
          comparer_(*found_, *scene_, background),
          right_(std::move(right)),
          background_found_(background_found) {}

    std::string at(Pixel pixel) const {
        const auto i =
            static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(found_->width()) + static_cast<std::size_t>(pixel.x);
        if (!comparer_.shows(i, right_[i], {})) return in_words(*scene_, comparer_.difference(i, right_[i], background_found_));
        return "pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y) + ": " + in_words(comparer_.found(i)) + " (" +
               called(*scene_, right_[i]) + "), as expected";
    }

    std::shared_ptr<const Image> right_picture() const {
        const auto picture = std::make_shared<Image>(found_->width(), found_->height(), 3);
        for (std::size_t i = 0; i < right_.size(); ++i) {
            const Color color = comparer_.right(right_[i]);
            std::uint8_t* rgb = picture->bytes().data() + 3 * i;
            rgb[0] = color.r;
            rgb[1] = color.g;
            rgb[2] = color.b;
        }
        return picture;
    }

private:
    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const Image> found_;
    Comparer comparer_;
    std::vector<std::int32_t> right_;
    std::optional<Color> background_found_;
};

}  // namespace

void ask_for_comparison(ViewerState& state) {
    FileBrowser browser = file_dialog(state);
    browser.title = "Compare with a picture";
    browser.kinds = {{"Pictures", picture_endings}, {"All files", {}}};
    browser.accept = [&state](const std::string& path, PictureSize) { compare_with(state, path); };
    state.dialogs.push_back(std::move(browser));
}

void compare_with(ViewerState& state, const std::string& path) {
    const auto fail = [&state](const std::string& why) { report_error(state, "The picture cannot be compared", why); };
    try {
        const auto scene = std::make_shared<const Scene>(state.scene());
        const auto found = std::make_shared<ShownComparison>();
        const Background background = state.shown_background();
        BackgroundJob job([scene, found, background, path](WorkControl& control) {
            const auto picture = std::make_shared<const Image>(read_picture(path));
            control.check();
            const PictureSize size{picture->width(), picture->height()};
            WrongPictures wrong(*scene, size);
            Image marked;
            const Diagnosis diagnosis = diagnose(*picture, *scene, background, wrong, &marked);
            found->words = in_words(diagnosis, *scene, path, size);
            if (diagnosis.different == 0) return;
            const auto compared =
                std::make_shared<const Compared>(scene, picture, background, wrong.numbers({}), diagnosis.background);
            found->words.at = [compared](Pixel pixel) { return compared->at(pixel); };
            found->difference = std::make_shared<const Image>(std::move(marked));
            found->found = picture;
            found->right = compared->right_picture();
        });
        const auto done = [&state, found] { state.comparison = *found; };
        state.comparing.emplace(Work{.path = path, .job = std::move(job), .done = done, .fail = fail});
    } catch (...) {
        fail(describe_current_exception(path).message);
    }
}

}  // namespace sphereview

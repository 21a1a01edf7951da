#include "viewer/picture_comparison.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/compare_words.hpp"
#include "app/failure.hpp"
#include "base/path.hpp"
#include "base/text.hpp"
#include "exact/visible.hpp"
#include "image/picture_file.hpp"
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
struct Compared {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const Image> found;
    std::vector<std::int32_t> right;  // the numbers, row by row
    Color right_background;
    Color found_background;

    Color expected(std::size_t i) const {
        return right[i] == visible_background ? right_background : scene->spheres[static_cast<std::size_t>(right[i])].color;
    }

    std::string at(Pixel pixel) const {
        const std::uint8_t* rgb = found->at(pixel.x, pixel.y);
        const auto i =
            static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(found->width()) + static_cast<std::size_t>(pixel.x);
        DifferingPixel here{.pixel = pixel, .found = {rgb[0], rgb[1], rgb[2]}};
        here.expected_number = right[i];
        here.expected = expected(i);
        if (here.found == here.expected) {
            return "pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y) + ": " + in_words(here.found) + " (" +
                   called(*scene, right[i]) + "), as expected";
        }
        const auto is_it = [&](const Sphere& sphere) { return !sphere.hidden && sphere.color == here.found; };
        const auto sphere = std::ranges::find_if(scene->spheres, is_it);
        if (here.found == found_background) {
            here.found_number = visible_background;
        } else if (sphere != scene->spheres.end()) {
            here.found_number = static_cast<std::int32_t>(sphere - scene->spheres.begin());
        }
        return in_words(*scene, here);
    }

    std::shared_ptr<const Image> right_picture() const {
        const auto picture = std::make_shared<Image>(found->width(), found->height(), 3);
        for (std::size_t i = 0; i < right.size(); ++i) {
            const Color color = expected(i);
            std::uint8_t* rgb = picture->bytes().data() + 3 * i;
            rgb[0] = color.r;
            rgb[1] = color.g;
            rgb[2] = color.b;
        }
        return picture;
    }
};

}  // namespace

void ask_for_comparison(ViewerState& state) {
    FileBrowser browser = file_dialog(state);
    browser.title = "Compare with a picture";
    browser.kinds = {{"Pictures", {".png", ".ppm", ".pgm", ".bmp"}}, {"All files", {}}};
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
            const auto compared = std::make_shared<const Compared>(
                Compared{scene, picture, wrong.numbers({}), background.color, diagnosis.background.value_or(background.color)});
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

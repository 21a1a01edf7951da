#include "viewer/picture_comparison.hpp"

#include <cstdint>
#include <utility>

#include "app/compare_words.hpp"
#include "app/failure.hpp"
#include "base/path.hpp"
#include "base/text.hpp"
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
            const Image picture = read_picture(path);
            control.check();
            const PictureSize size{picture.width(), picture.height()};
            WrongPictures wrong(*scene, size);
            Image marked;
            const Diagnosis diagnosis = diagnose(picture, *scene, background, wrong, &marked);
            found->words = in_words(diagnosis, *scene, path, size);
            if (diagnosis.different > 0) found->difference = std::make_shared<const Image>(std::move(marked));
        });
        const auto done = [&state, found] { state.comparison = *found; };
        state.comparing.emplace(Work{.path = path, .job = std::move(job), .done = done, .fail = fail});
    } catch (...) {
        fail(describe_current_exception(path).message);
    }
}

}  // namespace sphereview

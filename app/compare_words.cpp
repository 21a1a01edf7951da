#include "app/compare_words.hpp"

#include "base/text.hpp"
#include "exact/explain.hpp"

namespace sphereview {

std::vector<std::string> verdict_in_words(const Diagnosis& diagnosis) {
    if (!diagnosis.style.empty()) return {diagnosis.style_words};
    if (diagnosis.likeliest.empty()) return {"likeliest mistake: none of the usual ones"};
    const auto count = [](std::int64_t pixels) { return in_groups(static_cast<std::uint64_t>(pixels)); };
    if (diagnosis.likeliest.front() == "blank") return {diagnosis.likeliest_words};
    std::vector<std::string> lines = {
        "likeliest mistake: " + diagnosis.likeliest_words,
        "explains " + count(diagnosis.explained) + " of the pixels that differ" +
            (diagnosis.contradicting == 0 ? ", and contradicts none that is right"
                                          : "; " + count(diagnosis.contradicting) + " right ones speak against it")};
    if (!diagnosis.as_likely.empty()) lines.push_back("this picture cannot tell it from " + diagnosis.as_likely_words);
    return lines;
}

std::string in_words(const Scene& scene, const DifferingPixel& example) {
    const std::string found =
        example.found_number ? called(scene, *example.found_number) : std::string("a colour of nothing in the scene");
    const bool is_background = example.expected_number == visible_background;
    const auto with_alpha = [&](const Color& color, int alpha) {
        return in_words(color) + (example.alpha ? " with alpha " + std::to_string(alpha) : "");
    };
    return "pixel " + std::to_string(example.pixel.x) + "," + std::to_string(example.pixel.y) + ": found " +
           with_alpha(example.found, example.alpha.value_or(color_max)) + " (" + found + "), expected " +
           with_alpha(example.expected, is_background ? 0 : color_max) + " (" + called(scene, example.expected_number) + ")";
}

}  // namespace sphereview

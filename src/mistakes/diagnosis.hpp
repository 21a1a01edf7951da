// Finds the usual mistakes that explain why a picture of somebody's own ray tracer is wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "mistakes/comparer.hpp"
#include "mistakes/wrong_pictures.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// A mistake, and the number of differing pixels that it explains.
struct MistakeShare {
    std::string name;   // for programs
    std::string words;  // for people
    std::int64_t pixels = 0;
    Color mark{};  // its colour in the picture of the difference
};

struct Diagnosis {
    std::int64_t pixels = 0;
    std::int64_t different = 0;
    std::vector<std::string> likeliest{};    // the mistakes that together explain most; empty: no usual one
    std::string likeliest_words{};           // the same for people
    std::string style{};                     // "shaded" or "smoothed" if the picture looks so rather than wrong; else ""
    std::string style_words{};               // the same for people
    std::vector<std::string> as_likely{};    // single mistakes that this picture cannot tell from the likeliest one
    std::string as_likely_words{};           // the same for people
    std::optional<Color> background{};       // the likeliest mistake's background, if it is another
    std::int64_t explained = 0;              // differing pixels that the likeliest mistakes explain
    std::int64_t contradicting = 0;          // right pixels that these mistakes would change
    std::vector<MistakeShare> shares{};      // of all differing pixels, each counted once; the likeliest mistakes first
    std::vector<DifferingPixel> examples{};  // up to three, of the largest share
};

// Compares a picture with the scene's right flat one of the same size. With a transparent background alpha 0 is background; else
// alpha is passed over. `marked`, if not null, becomes the picture of the difference: equal pixels dimmed to a quarter, different
// ones in their share's mark.
Diagnosis diagnose(const Image& picture, const Scene& scene, const Background& background, WrongPictures& wrong,
                   Image* marked = nullptr);

}  // namespace sphereview

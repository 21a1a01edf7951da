// Why a picture of somebody's own ray tracer differs from the right one: which usual mistakes explain it.
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

// A mistake, and how many of the differing pixels show what it makes of them.
struct MistakeShare {
    std::string name;   // for programs
    std::string words;  // for people
    std::int64_t pixels = 0;
    Color mark{};  // its pixels in the picture of the difference
};

struct Diagnosis {
    std::int64_t pixels = 0;
    std::int64_t different = 0;
    std::vector<std::string> likeliest{};    // the names of the mistakes that together explain most; none: no usual one
    std::string likeliest_words{};           // the same for people
    std::string style{};                     // "shaded" or "smoothed" where the picture looks so, rather than wrong; else ""
    std::string style_words{};               // the same for people
    std::vector<std::string> as_likely{};    // names of single mistakes that this picture cannot tell from the likeliest one
    std::string as_likely_words{};           // the same for people
    std::optional<Color> background{};       // that the likeliest mistake has instead of the right one
    std::int64_t explained = 0;              // differing pixels that show what the likeliest mistakes make of them
    std::int64_t contradicting = 0;          // right pixels which those would change
    std::vector<MistakeShare> shares{};      // of all differing pixels, each counted once; the likeliest mistakes first
    std::vector<DifferingPixel> examples{};  // up to three, of the largest share
};

// Compares a picture with the right flat one of the scene at the same size. Where that has a transparent background, alpha 0 is
// background; otherwise alpha is passed over. `marked`: where a picture of the difference is wanted: equal pixels dimmed to a
// quarter, different ones in their share's mark.
Diagnosis diagnose(const Image& picture, const Scene& scene, const Background& background, WrongPictures& wrong,
                   Image* marked = nullptr);

}  // namespace sphereview

// Tells whether a picture differs from the flat one in style, rather than being wrong.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "mistakes/comparer.hpp"

namespace sphereview {

enum class PictureStyle {
    flat,     // or unknown
    shaded,   // the right outlines, with many colours on a sphere
    smoothed  // the right colours, mixed at the outlines
};

struct PictureStyleWords {
    std::string_view name;   // for programs; "" for flat
    std::string_view words;  // for people
};
PictureStyleWords words_of(PictureStyle style);

// numbers: what each pixel should show, row by row.
PictureStyle style_of(const Comparer& comparer, const std::vector<std::int32_t>& numbers, PictureSize size);

}  // namespace sphereview

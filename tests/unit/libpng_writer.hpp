// PNGs of every kind as inputs for our reader, which writes and reads with stb.
#pragma once

#include <png.h>

#include <cstdint>
#include <string>
#include <vector>

namespace sphereview {

// What libpng shall write. `rows` holds the packed bytes of all rows, top row first, as the PNG standard lays them out.
struct PngSpec {
    int width = 1;
    int height = 1;
    int color_type = PNG_COLOR_TYPE_RGB;
    std::vector<std::uint8_t> rows;
    int depth = 8;
    bool interlaced = false;
    std::vector<png_color> palette = {};
    std::vector<std::uint8_t> palette_alpha = {};  // a tRNS chunk for the first colours of the palette
    bool has_clear_color = false;                  // a tRNS chunk that makes one colour of an RGB or grey picture transparent
    png_color_16 clear_color{};
};

std::string libpng_written(PngSpec spec);

}  // namespace sphereview

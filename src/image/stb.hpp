// What stb_image_write does not tell the compressor that it is given.
#pragma once

#include "image/run_deflate.hpp"

namespace sphereview {

// How the data of the PNG repeats itself that this thread is writing.
RowLayout& png_layout();

}  // namespace sphereview

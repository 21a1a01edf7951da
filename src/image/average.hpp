// Several points a pixel -> one colour. The average is of the stored bytes, not of linear light: a scene's colours are numbers
// without a colour space. Anyone can check an average, or make another one from the larger picture.
#pragma once

#include "image/image.hpp"

namespace sphereview {

// Each pixel of `picture` from (x, y) on becomes the average of the side x side pixels of `points` that belong to it; `points` has
// `side` times the width and height of that part of the picture, and as many channels. side: 1, 2 or 4.
// Whole numbers, halves rounded up: round(sum / n) of the stored bytes. With alpha, a: round(sum a / n), and each colour counts as
// much as its point covers: round(sum (a colour) / sum a); where a is 0, all is 0.
void average_into(const Image& points, int side, Image& picture, int x, int y);

}  // namespace sphereview

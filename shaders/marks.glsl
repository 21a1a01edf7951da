// The buffer of marks has a texel for each of the visible-sphere buffer, with the number of a selected sphere or one of these.
// Twin: src/gpu/outlines.cpp.
#include "draw.glsl"

const int no_mark = -1;
const int hovered_mark = -2;  // the hovered sphere, when it is not selected

// The buffer of busy cells has a texel for each 2^cell_shift columns and rows of marks.
const int cell_shift = 3;

// How many pixels a pixel's outline is at most away from its sphere.
int outline_reach() { return int(outline + 2.5); }

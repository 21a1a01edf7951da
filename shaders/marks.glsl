// The buffer of marks has for each pixel of the picture the index of a selected sphere or one of these.
// Twin: src/gpu/outlines.cpp.
#include "draw.glsl"

const int no_mark = -1;
const int hovered_mark = -2;  // the hovered sphere, when it is not selected
// So many spheres are selected that they are outlined as one.
const int set_mark = -3;
const int hovered_set_mark = -4;  // the hovered one of these

// A colour's alpha is more where its sphere is selected and outlined alone; 0: not selected. Twin: src/gpu/shown_colors.cpp.
const float alone = 0.75;

// The buffer of busy cells has a texel for each 2^cell_shift columns and rows of marks.
const int cell_shift = 3;

bool is_of_set(int mark) { return mark <= set_mark; }

// How many pixels a pixel's outline is at most away from its sphere.
int outline_reach() { return int(outline + 2.5); }

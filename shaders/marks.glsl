// What the buffer of marks holds for each texel of the visible-sphere buffer: the number of a selected sphere, or one of these.
const int no_mark = -1;
const int hovered_mark = -2;  // the hovered sphere, when it is not selected

// What the visible-sphere buffer holds besides a sphere's number. Twin: src/exact/visible.hpp.
const int visible_background = -1;

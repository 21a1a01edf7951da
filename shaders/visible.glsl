// What the visible-sphere buffer holds besides a sphere's number. Twin: src/exact/visible.hpp.
const int visible_background = -1;
const int first_doubtful_sphere = -3;

// The doubtful form of a guess; its own inverse.
int doubtful(int guess) { return first_doubtful_sphere - guess; }

int best_guess(int number) { return number < visible_background ? doubtful(number) : number; }

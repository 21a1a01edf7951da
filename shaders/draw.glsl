// What one draw needs to know. Twin: DrawBlock in src/gpu/layouts.hpp.
layout(std140) uniform Draw {
    vec4 forward;        // a pixel's ray is forward + across right + upward up (xyz); orthographic: forward, from
    vec4 right;          // across right + upward up, relative to the eye, which are no larger than forward.w
    vec4 up;
    vec4 background;     // colour where no sphere is, 0..1, with alpha
    ivec2 picture_size;  // of the whole picture, in pixels
    ivec2 block_origin;  // top left pixel of what is drawn
    float error_scale;   // c(kappa, u) of docs/exactness.md
    int all_doubtful;    // not 0: float proves nothing about this scene
    int level_count;     // of tiles
    int grid_shift;      // the visible-sphere buffer has a texel for each 2^this columns and rows of pixels
    ivec2 window_corner; // of the picture's top left pixel, as gl_FragCoord counts in the window
    int hovered;         // the index of the sphere under the pointer; -1: none
    float outline;       // width of the selected spheres' outlines, in pixels
    int checkerboard;    // not 0: where nothing is, a window shows squares of 2^this pixels instead of transparency
    int shading;         // a mode of surface.frag
    float nearest_depth; // of the scene's hits, as far from the eye as spheres.glsl has it; and the inverse of the range from there
    float inverse_depth_range;
    vec4 axis_right;     // the camera's axes, each of length 1 (xyz): right, up, to the eye's side of the screen
    vec4 axis_up;
    vec4 axis_toward;
    vec4 key_light;      // the direction to the key light, of length 1 (xyz); the strength of sky and key (w)
    vec4 sun_light;      // the direction to the sun, as long as the sun is strong (xyz); the part of the key (w)
    ivec4 levels[8];     // x: a tile's side is 2^x pixels; y: tiles in a row; z: the number of the first
};

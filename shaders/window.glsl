// A picture in a window: the visible-sphere buffer's top row becomes the top row of the window's area.
#include "draw.glsl"

// The pixel of the picture, (0, 0) at the top left, that is drawn here.
ivec2 window_pixel() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    return ivec2(at.x - window_corner.x, window_corner.y - at.y);
}

// The texel of the buffer that stands for a pixel; for one outside the picture, its nearest. (Shifts: llvmpipe's divisions of
// integers take longer than all the rest of a shader.)
ivec2 texel_of(ivec2 pixel) { return clamp(pixel, ivec2(0), picture_size - 1) >> grid_shift; }

// A picture in a window: the visible-sphere buffer's top row becomes the top row of the window's area.
#include "draw.glsl"

// The pixel of the picture, (0, 0) at the top left, that is drawn here.
ivec2 window_pixel() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    return ivec2(at.x - window_corner.x, window_corner.y - at.y);
}

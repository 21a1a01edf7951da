// The outlines of selected and hovered spheres, drawn over a picture in a window. Twin: shaders/marks.glsl.
#pragma once

#include "exact/candidates.hpp"
#include "gpu/gl_object.hpp"
#include "gpu/layouts.hpp"
#include "gpu/number_target.hpp"

namespace sphereview {

// Part of the window's framebuffer, in GL's coordinates: (x, y) is the bottom left corner.
struct WindowArea {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

// Made from mark.frag, busy.frag and outline.frag.
struct OutlinePrograms {
    Program mark;
    Program coarse_mark;  // of coarse pictures
    Program busy;
    Program outline;
};

// The shaders shift instead of dividing: an integer division for each pixel made a redraw on llvmpipe three times as long. Outlines
// are searched for only in cells near a marked sphere.
class Outlines {
public:
    // Draws the outlines of the picture in `visible` into the framebuffer `window`. `block`: uploaded already. `range`: pixels
    // outside show no marked sphere.
    void draw(const OutlinePrograms& programs, const VertexArray& no_vertices, const NumberTarget& visible, const DrawBlock& block,
              const PixelRange& range, const WindowArea& area, GLuint window);

private:
    NumberTarget marks_;  // one for each pixel of the picture
    NumberTarget busy_;   // one for each cell of those
};

}  // namespace sphereview

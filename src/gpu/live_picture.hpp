// The picture of a scene that is being edited and moved about, drawn into a window again and again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exact/resolve.hpp"
#include "gpu/gpu_renderer.hpp"
#include "scene/document.hpp"
#include "scene/selection.hpp"

namespace sphereview {

// What a picture shows.
struct View {
    Camera camera;
    PictureSize size;  // in the window's framebuffer pixels

    bool operator==(const View&) const = default;
};

// Part of the window's framebuffer, in GL's coordinates: (x, y) is the bottom left corner.
struct WindowArea {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

// What is marked by an outline.
struct Highlights {
    const Selection* selection = nullptr;
    std::optional<std::uint32_t> hovered;
    float thickness = 1.0F;  // pixels
};

// Belongs to the current context, like GpuRenderer. It alone decides what to upload and whether anything must be traced again.
class LivePicture {
public:
    // Compiles the shaders, from `shader_folder` if it is not empty. Throws RenderError.
    explicit LivePicture(const std::string& shader_folder = "");

    // Brings the picture up to date: traces every step-th pixel of each row and column (each for the step x step pixels around
    // it), if what is there is coarser than that or of another scene or view. With step 1 all pixels. Returns whether it
    // traced. Throws TooLarge, RenderError.
    bool update(const Document& document, const View& view, int step);

    // How long the last update() that traced took on this device, in seconds, and the step it was for.
    double last_seconds() const;
    int step() const;

    // Colours the picture into the bound framebuffer and draws the outlines over it.
    void show(const WindowArea& area, const Background& background, const Highlights& highlights);

    // The number of the sphere that a pixel of the picture shows, or visible_background. From the visible-sphere buffer where that
    // is sure; a pixel that is doubtful, or that was not traced itself, is decided on the CPU.
    std::int32_t pick(const Document& document, Pixel pixel);

    // Reads the shaders in the folder again. What does not compile leaves the last good ones running. Returns the log, naming
    // file and line, or "" when all is well.
    std::string reload_shaders();

    // "uniform buffer", "buffer textures" or "2D textures".
    std::string storage() const;
};

}  // namespace sphereview

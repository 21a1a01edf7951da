// Dear ImGui between the window's events and its framebuffer, and pictures as ImGui draws them.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "gpu/gl_object.hpp"
#include "image/image.hpp"
#include "panels/widgets.hpp"
#include "platform/window.hpp"

namespace sphereview {

// ImGui's context, fonts and renderer. Keys come from the window's events, so any release of ImGui works.
class ImguiBridge {
public:
    // Needs the window's context to be current. `text_scale`: the person's, besides the system's.
    ImguiBridge(Window& window, double text_scale, Theme theme);
    ~ImguiBridge();
    ImguiBridge(const ImguiBridge&) = delete;
    ImguiBridge& operator=(const ImguiBridge&) = delete;

    void set_text_scale(double text_scale) { text_scale_ = text_scale; }
    void set_theme(Theme theme);

    // Begins a redraw with these events. A change of the screen's scale builds the fonts anew.
    // `navigates`: arrows, Enter and Escape move through what has popped up, such as a menu.
    void begin_redraw(const std::vector<InputEvent>& events, double seconds_since_last, bool navigates);
    // Ends the redraw; render() draws it into the bound framebuffer. Returns whether what it draws differs from the redraw before.
    bool end_redraw();
    void render();

    // The factor for sizes in ImGui's coordinates: 1 on usual screens.
    float scale() const { return scale_; }

private:
    void feed(const InputEvent& event);
    void build_fonts();

    Window& window_;
    ImGuiContext* context_;
    double text_scale_;
    Theme theme_;
    float scale_ = 0.0F;
    float font_pixels_ = 0.0F;  // size of the built fonts
    std::size_t drawn_ = 0;     // a hash of what the last redraw draws
};

// A picture in the window's context, which ImGui draws at a smaller size.
class PictureTexture {
public:
    // The picture's texture; nothing for null and for a picture larger than textures can be.
    std::optional<ImTextureID> follow(const std::shared_ptr<const Image>& picture);

private:
    std::shared_ptr<const Image> uploaded_{};
    Texture texture_;
};

}  // namespace sphereview

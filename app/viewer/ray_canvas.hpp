// Draws lines, marks and words of the rays in space over a picture, faint where a sphere is in front of them.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "camera/projected_line.hpp"
#include "panels/panel_context.hpp"
#include "viewer/hidden_parts.hpp"

namespace sphereview {

struct ViewerState;

// The window's picture under the rays.
struct DrawnOver {
    const SeenTexels& seen;  // by the present picture
    Rectangle area;
    double pixels = 1.0;  // a screen coordinate's
    float scale = 1.0F;
};

struct Ink {
    int red = 255;
    int green = 255;
    int blue = 255;
    double opacity = 1.0;

    ImU32 times(double factor) const {
        return IM_COL32(red, green, blue, static_cast<int>(std::lround(255.0 * std::clamp(opacity * factor, 0.0, 1.0))));
    }
};

inline constexpr Ink word_ink{235, 240, 250, 0.95};
inline constexpr Ink first_ink{255, 220, 90, 1.0};
inline constexpr Ink second_ink{120, 205, 255, 1.0};
inline constexpr Ink sun_ink{255, 176, 46, 1.0};
inline constexpr Ink dark_ink{10, 12, 18, 0.75};

// Inks that are visible on the picture's background.
struct Inks {
    Ink edge{235, 240, 250, 0.85};
    Ink grid{235, 240, 250, 0.30};
    Ink frustum{235, 240, 250, 0.40};
    Ink missed{170, 180, 200, 0.32};
    bool on_light = false;

    // The colour of the sphere that a ray hits, lighter on a dark ground and darker on a light one.
    Ink of(const Scene& scene, std::int32_t number) const {
        if (!has_sphere(scene, number)) return missed;
        const Color& color = scene.spheres[static_cast<std::size_t>(number)].color;
        const auto part = [&](std::uint8_t byte) { return (on_light ? 0 : 90) + byte * 165 / 255; };
        return {part(color.r), part(color.g), part(color.b), 0.62};
    }
};

Inks inks_on(const Background& background);

inline constexpr double behind_sphere = 0.22;  // the part of its opacity that a hidden line keeps

// Screen coordinates between two tests whether a line is hidden.
inline constexpr double usual_step = 2.0;

// `state` and `over` must outlive this object.
class RayCanvas {
public:
    RayCanvas(const ViewerState& state, const DrawnOver& over);

    ImDrawList& list() const { return draw_; }
    const DrawnOver& over() const { return over_; }

    // The screen coordinates of a place in the picture, in its pixels.
    ImVec2 on_window(const glm::dvec2& place) const;
    // The places of points of the scene; nothing for points behind the eye.
    std::optional<glm::dvec2> place(const glm::dvec3& point) const;
    std::optional<ProjectedLine> projected(const glm::dvec3& from, const glm::dvec3& to) const;
    bool is_hidden(const glm::dvec3& point) const;

    void line(const glm::dvec3& from, const glm::dvec3& to, const Ink& ink, float width, double step = usual_step) const;
    void dot_at(const glm::dvec3& point, const Ink& ink, float radius) const;
    void ring_at(const glm::dvec3& point, const Ink& ink, float radius) const;
    // Words on a dark ground, centred at a place of the window.
    void words(ImVec2 middle, const std::string& text, const Ink& ink) const;

private:
    const ViewerState& state_;
    const DrawnOver& over_;
    HiddenParts hidden_;
    ImDrawList& draw_;
};

}  // namespace sphereview

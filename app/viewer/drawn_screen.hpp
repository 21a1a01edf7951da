// The screen of an eye that is seen from beside: its edge, a grid, and the picture on it.
#pragma once

#include <imgui.h>

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "viewer/ray_canvas.hpp"

namespace sphereview {

struct RaysInSpace;

// What it is given must outlive it. `texture`: the picture, if there is one yet.
class DrawnScreen {
public:
    DrawnScreen(const RayCanvas& canvas, const RaysInSpace& rays, const std::optional<ImTextureID>& texture, const Inks& inks);

    void draw() const;

    // In the scene.
    const std::array<glm::dvec3, 4>& corners() const { return corners_; }

private:
    glm::dvec3 on_screen(const glm::dvec2& place) const;
    int grid_cell() const;
    void draw_patch(const glm::dvec2& low, const glm::dvec2& high, int halvings) const;
    void halve(const glm::dvec2& low, const glm::dvec2& high, const std::array<glm::dvec2, 4>& places, bool is_before,
               int halvings) const;
    double visible_part(const glm::dvec2& low, const glm::dvec2& high) const;
    glm::dvec3 point_on_screen(const glm::dvec2& part) const;
    bool is_outside(const std::array<ImVec2, 4>& points) const;

    const RayCanvas& canvas_;
    const RaysInSpace& rays_;
    const std::optional<ImTextureID>& texture_;
    const Inks& inks_;
    std::array<glm::dvec3, 4> corners_;
};

}  // namespace sphereview

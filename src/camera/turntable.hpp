// A camera that goes round a scene. Uses + - * / and square roots, and base/sine_cosine.hpp: the same doubles on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>

#include "camera/fit.hpp"
#include "scene/camera.hpp"

namespace sphereview {

// The axis of a turn: the camera's own upward direction, or an axis of the scene.
enum class TurnAxis { up, x, y, z };

// By their values.
inline constexpr std::array<std::string_view, 4> turn_axis_names = {"up", "x", "y", "z"};

// Nothing for any other text.
std::optional<TurnAxis> turn_axis_named(std::string_view name);

// A turn about a place. The eye of an upright camera goes to the right first, as with growing azimuth.
class Turn {
public:
    // `axes`: those of the camera that turns.
    Turn(const ViewAxes& axes, TurnAxis axis);

    // A direction after a turn by `degrees`; 0 changes no bit.
    glm::dvec3 direction(const glm::dvec3& v, double degrees) const;
    glm::dvec3 place(const glm::dvec3& point, const glm::dvec3& pivot, double degrees) const;
    ViewAxes axes(const ViewAxes& axes, double degrees) const;
    Camera camera(const Camera& camera, const glm::dvec3& pivot, double degrees) const;

private:
    glm::dvec3 axis_;  // of length 1; right-handed
};

// The angle of picture `index` of `count`.
inline double degrees_of(std::int64_t index, std::int64_t count) {
    return 360.0 * static_cast<double>(index % count) / static_cast<double>(count);
}

}  // namespace sphereview

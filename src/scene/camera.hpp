// The eye, the screen and the ray through each pixel.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sphereview {

// Width and height of a picture in pixels, both at least 1.
struct PictureSize {
    int width = 1000;
    int height = 1000;

    int shorter_side() const { return width < height ? width : height; }
    bool operator==(const PictureSize&) const = default;
};

// A pixel: column x from the left, row y from the top.
struct Pixel {
    int x = 0;
    int y = 0;

    bool operator==(const Pixel&) const = default;
};

// Where rays begin. Perspective: all in the eye, and each goes through its pixel's place on the screen. Orthographic: all go from
// the eye to the screen's centre, and each begins in the plane through the eye that is parallel to the screen, at its pixel's
// place.
enum class Projection { perspective, orthographic };

// By their values.
inline constexpr std::array<std::string_view, 2> projection_names = {"perspective", "orthographic"};

constexpr std::string_view name_of(Projection projection) { return projection_names[static_cast<std::size_t>(projection)]; }

// Nothing for any other text.
constexpr std::optional<Projection> projection_named(std::string_view name) {
    if (name == projection_names[0]) return Projection::perspective;
    if (name == projection_names[1]) return Projection::orthographic;
    return std::nullopt;
}

// The camera is these twelve doubles, in scene space, and a projection. `right` and `up` lead from the screen's centre to the
// middle of its edges; they are perpendicular and equally long. The default is the screen (-50, -50, 100) .. (50, 50, 100) seen
// from 0.
struct Camera {
    glm::dvec3 eye{0.0, 0.0, 0.0};
    glm::dvec3 center{0.0, 0.0, 100.0};
    glm::dvec3 right{50.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 50.0, 0.0};
    Projection projection = Projection::perspective;

    bool orthographic() const { return projection == Projection::orthographic; }
    bool operator==(const Camera&) const = default;
};

// A camera's own directions, each of length 1. `ahead` is perpendicular to the screen and points away from the eye.
struct CameraAxes {
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 ahead;
    bool mirrored = false;  // x to the left, for an eye that sees y up
};

CameraAxes camera_axes(const Camera& camera);

// Tolerance for `right` and `up` being perpendicular and equally long, and least distance of the eye from the screen's plane,
// relative to the lengths of the vectors involved.
inline constexpr double camera_tolerance = 1e-6;

// What is wrong with a camera: "'up' is not perpendicular to 'right'".
struct CameraFault {
    std::string what;
    std::vector<std::string_view> vectors;  // of "eye", "center", "right", "up", the likeliest mistake first
};

std::optional<CameraFault> camera_fault(const Camera& camera);

// The coefficients of pixel (x, y)'s ray O + t D, times the shorter side m: m D = m (center - eye) + across right + upward up, with
// D = (center - eye) + (2x + 1 - W) / m right + (H - 1 - 2y) / m up, and O = eye. Orthographic: D = center - eye, and
// m O = m eye + across right + upward up. Whole numbers, so that nothing is rounded.
struct RayCoefficients {
    long long across = 0;
    long long upward = 0;
};

constexpr RayCoefficients ray_coefficients(PictureSize size, Pixel pixel) {
    return {2LL * pixel.x + 1 - size.width, size.height - 1 - 2LL * pixel.y};
}

// Anti-aliasing: a pixel is the average of the points of a regular grid in it. The possible numbers of points; the first is the
// default.
inline constexpr std::array<int, 3> sample_counts = {1, 4, 16};
inline constexpr const char* sample_counts_text = "1, 4 or 16";

// The side of the grid in a pixel: samples = side x side.
constexpr int sample_side(int samples) { return samples == 16 ? 4 : samples == 4 ? 2 : 1; }

// The points of a picture are exactly the pixel centres of the same camera's picture of `side` times the size: point (i, j) of
// pixel (x, y) is pixel (side x + i, side y + j) there; m and the rays' coefficients scale alike. So all that holds for pixels
// holds for points.
constexpr PictureSize sampled_size(PictureSize size, int side) { return {size.width * side, size.height * side}; }

}  // namespace sphereview

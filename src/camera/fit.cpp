#include "camera/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <mutex>

#include "base/number.hpp"
#include "base/parallel.hpp"
#include "base/square_root.hpp"
#include "camera/navigation.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr std::size_t centers_at_once = 16384;

// The default camera's distance of the screen, and half of the screen's side.
constexpr double distance = 100.0;
constexpr double half_side = 50.0;
// The slope of the planes that everything lies between: the screen's edges, less the margin.
constexpr double slope = half_side / distance * (31.0 / 32.0);

// What is smaller than this part of its distance from the origin counts as larger: an eye's numbers could not place it well enough.
constexpr double smallest_part = 0x1p-46;
// The scale that brings smaller ones near 1 would leave the range of doubles.
constexpr double smallest_radius = 0x1p-1000;
// For an eye: its screen's numbers must be finite as well.
constexpr double farthest = 0x1p1023;

ViewAxes axes_from(const SineCosine& azimuth, const SineCosine& elevation) {
    const auto [sa, ca] = azimuth;
    const auto [se, ce] = elevation;
    return {without_negative_zero({ca, 0.0, sa}), without_negative_zero({-sa * se, ce, ca * se}),
            without_negative_zero({-sa * ce, -se, ca * ce})};
}

// The planes of a slope that bound the spheres: to the right, the left, up and down. With X, Y and Z along the view's axes,
// a plane's number is the greatest X - slope Z of a point of a sphere, and so for the others.
using Planes = std::array<double, 4>;

constexpr double least = -std::numeric_limits<double>::max();

void include(Planes& planes, const Planes& others) {
    for (std::size_t i = 0; i < planes.size(); ++i) planes[i] = std::max(planes[i], others[i]);
}

// Lengths relative to a place near the spheres, in a unit near their size: a power of two, so nothing is rounded.
struct Vicinity {
    explicit Vicinity(const SceneBounds& bounds) : origin(bounds.middle()) {
        smallest = std::max(smallest_part * largest_of(origin), smallest_radius);
        exponent = std::ilogb(std::max(bounds.extent(), smallest));
        scale = std::ldexp(1.0, -exponent);
    }

    // The differences of numbers near the largest double must not overflow.
    glm::dvec3 place(const glm::dvec3& point) const {
        return {point.x * scale - origin.x * scale, point.y * scale - origin.y * scale, point.z * scale - origin.z * scale};
    }

    // Where an eye at such a place is in the scene.
    glm::dvec3 eye(const ViewAxes& axes, double x, double y, double z) const {
        glm::dvec3 eye{0.0};
        for (int i = 0; i < 3; ++i) {
            const double scaled = origin[i] * scale + (x * axes.right[i] + y * axes.up[i] + z * axes.ahead[i]);
            eye[i] = std::clamp(std::ldexp(scaled, exponent), -farthest, farthest);
        }
        return without_negative_zero(eye);
    }

    glm::dvec3 origin;
    double smallest = 0.0;  // what radii count as, at least
    int exponent = 0;
    double scale = 1.0;
};

Planes planes_of(const Sphere& sphere, const ViewAxes& axes, const Vicinity& vicinity, double steepness) {
    // A plane at a sphere's side is this much of its radius beyond its centre.
    const double reach = square_root(1.0 + steepness * steepness);
    const glm::dvec3 place = vicinity.place(sphere.center);
    const double x = dot(place, axes.right);
    const double y = dot(place, axes.up);
    const double size = reach * (std::max(sphere.radius, vicinity.smallest) * vicinity.scale) - steepness * dot(place, axes.ahead);
    return {size + x, size - x, size + y, size - y};
}

Planes planes_around(const Scene& scene, const ViewAxes& axes, const Vicinity& vicinity, double steepness) {
    Planes all{least, least, least, least};
    std::mutex mutex;
    parallel_pieces(scene.spheres.size(), centers_at_once, [&](std::size_t begin, std::size_t end) {
        Planes part{least, least, least, least};
        for (std::size_t i = begin; i < end; ++i) {
            const Sphere& sphere = scene.spheres[i];
            if (!sphere.hidden) include(part, planes_of(sphere, axes, vicinity, steepness));
        }
        const std::lock_guard lock(mutex);
        include(all, part);
    });
    return all;
}

// The screen's half is as large as what it shows. The eye is so far from the middle of everything that no turn about the middle
// brings a sphere into the plane that rays begin in.
Camera fitted_orthographic(const Scene& scene, const ViewAxes& axes, const Vicinity& vicinity, const SceneBounds& bounds) {
    const auto [right, left, up, down] = planes_around(scene, axes, vicinity, 0.0);
    const double x = 0.5 * (right - left);
    const double y = 0.5 * (up - down);
    const double half = std::max(0.5 * (right + left), 0.5 * (up + down)) * (32.0 / 31.0);
    const glm::dvec3 corner = vicinity.place(bounds.high);
    const double z = -(square_root(dot(corner, corner)) + half);
    const double edge = std::min(std::ldexp(half, vicinity.exponent), 0.25 * farthest);
    return camera_with(vicinity.eye(axes, x, y, z), distance / half_side * edge * axes.ahead, edge * axes.right, edge * axes.up,
                       Projection::orthographic);
}

}  // namespace

std::vector<Sphere> outermost(const Scene& scene, const ViewAxes& axes, Projection projection) {
    if (std::ranges::all_of(scene.spheres, &Sphere::hidden)) return {};
    const Vicinity vicinity(bounds_of(scene));
    const double steepness = projection == Projection::orthographic ? 0.0 : slope;
    // Of planes, then of the box around everything, then the largest sphere.
    constexpr std::size_t ends = 11;
    struct Outermost {
        std::array<double, ends> how_far;
        std::array<std::size_t, ends> sphere{};
    };
    Outermost all;
    all.how_far.fill(-std::numeric_limits<double>::infinity());
    std::mutex mutex;
    parallel_pieces(scene.spheres.size(), centers_at_once, [&](std::size_t begin, std::size_t end) {
        Outermost part;
        part.how_far.fill(-std::numeric_limits<double>::infinity());
        for (std::size_t i = begin; i < end; ++i) {
            const Sphere& sphere = scene.spheres[i];
            if (sphere.hidden) continue;
            const Planes planes = planes_of(sphere, axes, vicinity, steepness);
            const glm::dvec3& c = sphere.center;
            const double r = sphere.radius;
            const std::array<double, ends> places{planes[0], planes[1], planes[2], planes[3], c.x + r, r - c.x,
                                                  c.y + r,   r - c.y,   c.z + r,   r - c.z,   r};
            for (std::size_t k = 0; k < ends; ++k) {
                if (places[k] > part.how_far[k]) {
                    part.how_far[k] = places[k];
                    part.sphere[k] = i;
                }
            }
        }
        const std::lock_guard lock(mutex);
        for (std::size_t k = 0; k < ends; ++k) {
            const bool farther = part.how_far[k] > all.how_far[k];
            const bool earlier = part.how_far[k] == all.how_far[k] && part.sphere[k] < all.sphere[k];
            if (!farther && !earlier) continue;
            all.how_far[k] = part.how_far[k];
            all.sphere[k] = part.sphere[k];
        }
    });
    std::ranges::sort(all.sphere);
    std::vector<Sphere> spheres;
    for (std::size_t k = 0; k < ends; ++k) {
        if (k == 0 || all.sphere[k] != all.sphere[k - 1]) spheres.push_back(scene.spheres[all.sphere[k]]);
    }
    return spheres;
}

ViewAxes axes_from(double azimuth, double elevation) { return axes_from(sine_cosine(azimuth), sine_cosine(elevation)); }

ViewAxes isometric_axes() {
    const double half = square_root(0.5);
    return axes_from({half, half}, {square_root(1.0 / 3.0), square_root(2.0 / 3.0)});
}

ViewAxes axes_of(const Camera& camera) {
    const CameraAxes axes = camera_axes(camera);
    // Anew: a camera's own may be not quite perpendicular.
    const glm::dvec3 up = axes.mirrored ? cross(axes.right, axes.ahead) : cross(axes.ahead, axes.right);
    return {without_negative_zero(axes.right), without_negative_zero(up), without_negative_zero(axes.ahead)};
}

ViewAxes with_hand_of(const ViewAxes& present, const ViewAxes& view) {
    const auto is_mirrored = [](const ViewAxes& axes) { return dot(cross(axes.right, axes.up), axes.ahead) < 0.0; };
    if (is_mirrored(present) == is_mirrored(view)) return view;
    const auto turned = [](const glm::dvec3& v) { return without_negative_zero({v.x, v.y, -v.z}); };
    return {turned(view.right), turned(view.up), turned(view.ahead)};
}

std::optional<ViewAxes> parse_view(std::string_view text) {
    if (text == "front") return axes_from(0.0, 0.0);
    if (text == "right") return axes_from(90.0, 0.0);
    if (text == "back") return axes_from(180.0, 0.0);
    if (text == "left") return axes_from(270.0, 0.0);
    if (text == "top") return axes_from(0.0, 90.0);
    if (text == "bottom") return axes_from(0.0, -90.0);
    if (text == "iso") return isometric_axes();
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) return std::nullopt;
    double azimuth = 0.0;
    double elevation = 0.0;
    if (parse_double(text.substr(0, comma), azimuth) != NumberFault::none) return std::nullopt;
    if (parse_double(text.substr(comma + 1), elevation) != NumberFault::none) return std::nullopt;
    if (!(elevation >= -90.0 && elevation <= 90.0)) return std::nullopt;
    return axes_from(azimuth, elevation);
}

std::optional<Camera> fitted(const Scene& scene, const ViewAxes& axes, Projection projection) {
    if (std::ranges::all_of(scene.spheres, &Sphere::hidden)) return std::nullopt;
    const SceneBounds bounds = bounds_of(scene);
    const Vicinity vicinity(bounds);
    if (projection == Projection::orthographic) return fitted_orthographic(scene, axes, vicinity, bounds);
    const auto [right, left, up, down] = planes_around(scene, axes, vicinity, slope);
    // Everything is before an eye at (X, Y, Z) if its own planes lie outside: X - slope Z >= right, -X - slope Z >= left, and so
    // for Y. So Z is at most what the two sums leave; X and Y then leave the same margin on either side.
    const double x = 0.5 * (right - left);
    const double y = 0.5 * (up - down);
    const double z = std::min(-0.5 * (right + left), -0.5 * (up + down)) / slope;
    return camera_with(vicinity.eye(axes, x, y, z), distance * axes.ahead, half_side * axes.right, half_side * axes.up);
}

}  // namespace sphereview

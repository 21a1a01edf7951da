// The plane through a ray, and the quadratics of the ray as curves: the places of the drawings, without their looks. In the plane
// lengths are the scene's; x runs along the ray from its origin, y across.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "exact/explain.hpp"
#include "scene/scene.hpp"

namespace sphereview {

struct SectionLine {
    glm::dvec2 from{0.0};
    glm::dvec2 to{0.0};
};

// A sphere's circle in the plane.
struct SectionCircle {
    std::int32_t number = 0;
    glm::dvec2 center{0.0};
    double radius = 0.0;  // the cut circle's, or the sphere's if not cut
    bool cut = true;      // false: the plane misses the sphere, and the circle is its outline
    bool met = false;     // the ray's line meets the sphere
    double first = 0.0;   // the x of the roots, if met
    double second = 0.0;
    bool first_counts = false;  // which root is the hit
    bool second_counts = false;
};

// A rectangle of the drawing.
struct SectionWindow {
    glm::dvec2 low{0.0};
    glm::dvec2 high{0.0};

    bool holds(const glm::dvec2& place) const {
        return place.x >= low.x && place.x <= high.x && place.y >= low.y && place.y <= high.y;
    }
    bool meets(const SectionWindow& other) const {
        return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
    }
};

struct RaySection {
    std::vector<SectionCircle> circles;  // the subject first
    bool has_subject = false;            // through whose centre the plane goes
    std::optional<SectionLine> screen;   // the plane's cut through the screen; the ray passes it at x = on_screen
    double on_screen = 0.0;
    std::optional<SectionLine> eye_plane;   // where parallel rays begin
    std::optional<double> seen;             // x of the hit that the pixel shows
    std::optional<SectionLine> to_sun;      // from that hit, projected onto the plane
    std::optional<std::int32_t> blocker{};  // the sphere at which to_sun ends
    SectionWindow window;                   // the part that is drawn
    bool eye_outside = false;               // the ray begins left of the window
    bool screen_outside = false;
    std::vector<std::int32_t> outside{};  // spheres outside the window
};

// The subject of a drawing.
struct SectionSubject {
    const Scene& scene;
    const Camera& camera;
    PictureSize size;
    Pixel pixel;
    const PixelExplanation& explanation;  // spheres that are gone are left out
    std::optional<glm::dvec3> sun{};      // the direction to the sun or another light, if shown
    std::optional<std::int32_t> blocker{};
    bool from_eye = true;             // false: the ray goes from a point to the sun, without a screen
    const char* name_of_sun = "sun";  // or "light"
};

// Whether the explanation has a hit or a near miss of that sphere.
bool is_explained(const PixelExplanation& explanation, std::int32_t number);
// The sphere of the nearest hit, else of the nearest near miss; visible_background for neither.
std::int32_t first_explained(const PixelExplanation& explanation);

// The ray from a pixel's point to the sun as an explanation, in double; t is a length. The blocking sphere is its hit; the point's
// own sphere lies behind it. Nothing if the pixel shows no sphere.
std::optional<PixelExplanation> shadow_ray(const Scene& scene, const PixelExplanation& pixel, const glm::dvec3& sun,
                                           std::optional<std::int32_t> blocker);

// `subject`: the sphere through whose centre the plane goes; by default, or if it is not in the explanation, first_explained().
// `aspect`: the drawing's width by its height. While the subject stays large enough to be seen, the window takes in the eye, the
// screen, the other hits, what blocks the sun, near misses, and what is behind the eye, in this order.
RaySection section_of(const SectionSubject& of, std::optional<std::int32_t> subject, double aspect);

// Points along the part of a circle that may be in the window; the whole circle, closed, if it is small.
std::vector<glm::dvec2> points_of(const SectionCircle& circle, const SectionWindow& window);

// The quadratic a t^2 + b t + c of a ray and a sphere as a curve, in units of a: t^2 + (b / a) t + c / a.
struct QuadraticCurve {
    std::int32_t number = 0;
    double lowest_t = 0.0;  // -b / (2 a)
    double lowest = 0.0;    // -discriminant / (4 a^2)
    int sign = 0;           // of the discriminant
    double t1 = 0.0;        // where it is not below 0
    double t2 = 0.0;
    bool first_counts = false;
    bool second_counts = false;

    double at(double t) const { return (t - lowest_t) * (t - lowest_t) + lowest; }
};

// All spheres of a ray have the same a, so their curves are one curve, moved: the lower its lowest point, the larger the
// discriminant.
struct QuadraticPlot {
    std::vector<QuadraticCurve> curves;  // the subject first
    double left = 0.0;                   // the drawn range of t
    double right = 1.0;
    double bottom = 0.0;  // the drawn range in units of a
    double top = 1.0;
    bool shows_origin = false;  // t = 0 is in the range
};

// `subject`: the sphere whose curve the plot is fitted to, as for section_of(). No curves if the ray hits and passes nothing.
QuadraticPlot plot_of(const PixelExplanation& explanation, std::int32_t subject);

}  // namespace sphereview

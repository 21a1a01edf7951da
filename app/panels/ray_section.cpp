#include "panels/ray_section.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "camera/navigation.hpp"
#include "panels/panel_context.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// What matters most is at least this part of the window's width.
constexpr double least_part = 1.0 / 9.0;

SectionWindow around(const glm::dvec2& place) { return {place, place}; }

SectionWindow around(const SectionCircle& circle) {
    return {circle.center - glm::dvec2(circle.radius), circle.center + glm::dvec2(circle.radius)};
}

SectionWindow around(const SectionLine& line) { return {glm::min(line.from, line.to), glm::max(line.from, line.to)}; }

SectionWindow united(const SectionWindow& a, const SectionWindow& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

// The width of a window of the drawing's shape.
double width_for(const SectionWindow& window, double aspect) {
    return std::max(window.high.x - window.low.x, aspect * (window.high.y - window.low.y));
}

// Grows by what fits.
class Fit {
public:
    Fit(const SectionWindow& first, double widest, double aspect) : window_(first), widest_(widest), aspect_(aspect) {}

    void add(const SectionWindow& more) {
        const SectionWindow all = united(window_, more);
        if (width_for(all, aspect_) <= widest_) window_ = all;
    }

    // With a margin, in the drawing's shape.
    SectionWindow window() const {
        constexpr double with_margin = 1.16;
        const double width = std::max(with_margin * width_for(window_, aspect_), std::numeric_limits<double>::min());
        const glm::dvec2 middle = 0.5 * window_.low + 0.5 * window_.high;
        const glm::dvec2 half{0.5 * width, 0.5 * width / aspect_};
        return {middle - half, middle + half};
    }

private:
    SectionWindow window_;
    double widest_;
    double aspect_;
};

// The plane's own directions.
class Plane {
public:
    Plane(const SectionSubject& of, const Sphere* subject)
        : origin_(of.explanation.origin), along_(unit(of.explanation.direction)), camera_(of.camera) {
        const glm::dvec3 up = across(of.camera.up);
        const glm::dvec3 usual = length_of(up) > 1e-9 * length_of(of.camera.up) ? unit(up) : unit(across(of.camera.right));
        across_ = usual;
        if (subject != nullptr) {
            const glm::dvec3 to_center = subject->center - origin_;
            const glm::dvec3 aside = across(to_center);
            if (largest_of(aside) > 1e-9 * (largest_of(to_center) + subject->radius)) across_ = unit(aside);
        }
        if (dot(across_, usual) < 0.0) across_ = -across_;
        normal_ = cross(along_, across_);
    }

    glm::dvec2 place(const glm::dvec3& point) const { return direction(point - origin_); }
    glm::dvec2 direction(const glm::dvec3& v) const { return {dot(v, along_), dot(v, across_)}; }
    double beside(const glm::dvec3& point) const { return dot(point - origin_, normal_); }

    // Where it cuts a rectangle that is parallel to the screen, as large as the screen, and goes through a point that is so far, in
    // halves of the picture's shorter side, from its middle.
    SectionLine cut(const glm::dvec3& point, const glm::dvec2& from_middle, const glm::dvec2& half) const {
        const glm::dvec3 way = unit(cross(cross(unit(camera_.right), unit(camera_.up)), normal_));
        const glm::dvec2 step = across_screen(camera_, way);
        double least = -infinite;
        double most = infinite;
        for (int axis = 0; axis < 2; ++axis) {
            if (std::fabs(step[axis]) < 1e-12 * std::max(std::fabs(step.x), std::fabs(step.y))) continue;
            const double one = (-half[axis] - from_middle[axis]) / step[axis];
            const double other = (half[axis] - from_middle[axis]) / step[axis];
            least = std::max(least, std::min(one, other));
            most = std::min(most, std::max(one, other));
        }
        return {place(point + least * way), place(point + most * way)};
    }

private:
    glm::dvec3 across(const glm::dvec3& v) const { return v - dot(v, along_) * along_; }

    glm::dvec3 origin_;
    glm::dvec3 along_;
    const Camera& camera_;
    glm::dvec3 across_;
    glm::dvec3 normal_;
};

bool is_finite(const SectionCircle& circle) {
    return std::isfinite(circle.center.x) && std::isfinite(circle.center.y) && std::isfinite(circle.radius) &&
           std::isfinite(circle.first) && std::isfinite(circle.second);
}

SectionCircle circle_of(const SectionSubject& of, const Plane& plane, std::int32_t number) {
    const Sphere& sphere = of.scene.spheres[static_cast<std::size_t>(number)];
    const double beside = plane.beside(sphere.center);
    SectionCircle circle{.number = number, .center = plane.place(sphere.center), .radius = sphere.radius};
    circle.cut = std::fabs(beside) < sphere.radius;
    if (circle.cut) circle.radius = std::sqrt(sphere.radius - beside) * std::sqrt(sphere.radius + beside);
    return circle;
}

std::vector<SectionCircle> circles_of(const SectionSubject& of, const Plane& plane, double length) {
    std::vector<SectionCircle> circles;
    const auto add = [&](const SectionCircle& circle) {
        if (is_finite(circle)) circles.push_back(circle);
    };
    for (const ExplainedHit& hit : of.explanation.hits) {
        if (!has_sphere(of.scene, hit.number)) continue;
        SectionCircle circle = circle_of(of, plane, hit.number);
        circle.met = true;
        circle.first = hit.t1 * length;
        circle.second = hit.t2 * length;
        circle.first_counts = hit.counts == CountingRoot::t1;
        circle.second_counts = !circle.first_counts;
        add(circle);
    }
    for (const SphereOnLine& passed : of.explanation.passed) {
        if (!has_sphere(of.scene, passed.number)) continue;
        SectionCircle circle = circle_of(of, plane, passed.number);
        circle.met = passed.discriminant_sign >= 0;
        if (circle.met) circle.first = passed.t1 * length;
        if (circle.met) circle.second = passed.t2 * length;
        add(circle);
    }
    const auto is_blocker = [&](const SectionCircle& circle) { return circle.number == of.blocker; };
    if (of.blocker && has_sphere(of.scene, *of.blocker) && std::ranges::none_of(circles, is_blocker)) {
        add(circle_of(of, plane, *of.blocker));
    }
    return circles;
}

// How far along a unit direction from a point the sphere begins.
double distance_to(const Sphere& sphere, const glm::dvec3& point, const glm::dvec3& direction) {
    const glm::dvec3 c = sphere.center - point;
    const double along = dot(c, direction);
    const double square = sphere.radius * sphere.radius - (dot(c, c) - along * along);
    return along - std::sqrt(std::max(square, 0.0));
}

// To what is in the way, or as far as the drawing goes.
SectionLine line_to_sun(const SectionSubject& of, const Plane& plane, const glm::dvec3& point, double far) {
    const glm::dvec3 direction = unit(*of.sun);
    const bool blocked = of.blocker && has_sphere(of.scene, *of.blocker);
    const double length =
        blocked ? std::max(distance_to(of.scene.spheres[static_cast<std::size_t>(*of.blocker)], point, direction), 0.0) : far;
    return {plane.place(point), plane.place(point + length * direction)};
}

// The order in which the circles get room, after the subject: hits, what blocks the sun, near misses, what is behind the eye.
int rank(const RaySection& section, const SectionCircle& circle) {
    if (circle.first_counts || circle.second_counts) return 0;
    if (circle.number == section.blocker) return 1;
    return circle.met ? 3 : 2;
}

SectionWindow window_for(const RaySection& section, double aspect) {
    const glm::dvec2 origin{0.0};
    if (!section.has_subject) {
        Fit fit(united(around(origin), around({1.3 * section.on_screen, 0.0})), infinite, aspect);
        if (section.screen) fit.add(around(*section.screen));
        return fit.window();
    }
    const SectionCircle& subject = section.circles.front();
    const bool hit = subject.first_counts || subject.second_counts;
    const double way = hit ? std::fabs(subject.first_counts ? subject.first : subject.second) : glm::length(subject.center);
    // A sphere like the ground under one's feet: the way to it is what matters.
    const bool huge = subject.radius > 4.0 * way && way > 0.0;
    const SectionWindow first = huge ? united(around(origin), around({subject.first_counts    ? subject.first
                                                                      : subject.second_counts ? subject.second
                                                                                              : way,
                                                                      0.0}))
                                     : united(around(subject), around({subject.center.x, 0.0}));
    Fit fit(first, width_for(first, aspect) / least_part, aspect);
    fit.add(around(origin));
    if (section.eye_plane) fit.add(around(*section.eye_plane));
    if (section.screen) fit.add(around({section.on_screen, 0.0}));
    if (section.screen) fit.add(around(*section.screen));
    for (int present = 0; present < 4; ++present) {
        for (const SectionCircle& circle : section.circles) {
            if (rank(section, circle) != present) continue;
            if (circle.met) fit.add(united(around({circle.first, 0.0}), around({circle.second, 0.0})));
            fit.add(around(circle));
        }
    }
    return fit.window();
}

}  // namespace

bool is_explained(const PixelExplanation& e, std::int32_t number) {
    return std::ranges::find(e.hits, number, &ExplainedHit::number) != e.hits.end() ||
           std::ranges::find(e.passed, number, &SphereOnLine::number) != e.passed.end();
}

std::int32_t first_explained(const PixelExplanation& e) {
    return !e.hits.empty() ? e.hits.front().number : !e.passed.empty() ? e.passed.front().number : visible_background;
}

RaySection section_of(const SectionSubject& of, std::optional<std::int32_t> subject, double aspect) {
    const PixelExplanation& e = of.explanation;
    const auto is_of = [&](std::int32_t number) { return has_sphere(of.scene, number) && is_explained(e, number); };
    if (!subject || !is_of(*subject)) subject = first_explained(e);
    const Sphere* sphere = is_of(*subject) ? &of.scene.spheres[static_cast<std::size_t>(*subject)] : nullptr;
    const Plane plane(of, sphere);
    const double length = length_of(e.direction);

    RaySection section;
    section.blocker = of.blocker;
    section.circles = circles_of(of, plane, length);
    const auto front = std::ranges::find(section.circles, *subject, &SectionCircle::number);
    section.has_subject = sphere != nullptr && front != section.circles.end();
    if (section.has_subject) std::rotate(section.circles.begin(), front, front + 1);
    if (!e.hits.empty() && std::isfinite(e.hits.front().t * length)) section.seen = e.hits.front().t * length;

    const double m = of.size.shorter_side();
    const RayCoefficients coefficients = ray_coefficients(of.size, of.pixel);
    const glm::dvec2 from_middle{static_cast<double>(coefficients.across) / m, static_cast<double>(coefficients.upward) / m};
    const glm::dvec2 half{of.size.width / m, of.size.height / m};
    section.on_screen = length;
    const SectionLine screen = plane.cut(e.origin + e.direction, from_middle, half);
    if (of.from_eye && std::isfinite(screen.to.x - screen.from.x) && std::isfinite(screen.to.y - screen.from.y))
        section.screen = screen;
    if (of.camera.orthographic() && section.screen) section.eye_plane = plane.cut(e.origin, from_middle, half);

    section.window = window_for(section, aspect);
    if (of.sun && section.seen) {
        section.to_sun = line_to_sun(of, plane, e.hits.front().point, section.window.high.x - section.window.low.x);
    }
    section.eye_outside = !section.window.holds(glm::dvec2(0.0));
    section.screen_outside = section.screen && !section.window.holds({section.on_screen, 0.0});
    for (const SectionCircle& circle : section.circles) {
        if (!around(circle).meets(section.window)) section.outside.push_back(circle.number);
    }
    return section;
}

std::optional<PixelExplanation> shadow_ray(const Scene& scene, const PixelExplanation& pixel, const glm::dvec3& sun,
                                           std::optional<std::int32_t> blocker) {
    if (pixel.hits.empty()) return std::nullopt;
    const ExplainedHit& seen = pixel.hits.front();
    if (!has_sphere(scene, seen.number)) return std::nullopt;
    PixelExplanation shadow;
    shadow.origin = seen.point;
    shadow.direction = unit(sun);
    const auto solve = [&](std::int32_t number, auto& out) {
        const Sphere& sphere = scene.spheres[static_cast<std::size_t>(number)];
        const glm::dvec3 from_center = shadow.origin - sphere.center;
        out.number = number;
        out.a = 1.0;
        out.b = 2.0 * dot(from_center, shadow.direction);
        // The point is on its own sphere.
        out.c = number == seen.number ? 0.0 : dot(from_center, from_center) - sphere.radius * sphere.radius;
        out.discriminant = std::max(out.b * out.b - 4.0 * out.c, 0.0);
        out.discriminant_sign = out.discriminant > 0.0 ? 1 : 0;
        const double root = std::sqrt(out.discriminant);
        out.t1 = 0.5 * (-out.b - root);
        out.t2 = 0.5 * (-out.b + root);
    };
    if (blocker && has_sphere(scene, *blocker)) {
        ExplainedHit& hit = shadow.hits.emplace_back();
        solve(*blocker, hit);
        hit.t = hit.t1;
    }
    solve(seen.number, shadow.passed.emplace_back());
    return shadow;
}

std::vector<glm::dvec2> points_of(const SectionCircle& circle, const SectionWindow& window) {
    constexpr int points = 96;
    const double diagonal = glm::length(window.high - window.low);
    double middle = 0.0;
    double half = std::numbers::pi;
    if (circle.radius > 2.0 * diagonal) {
        const glm::dvec2 to_window = 0.5 * window.low + 0.5 * window.high - circle.center;
        middle = std::atan2(to_window.y, to_window.x);
        half = std::asin(std::min(diagonal / circle.radius, 1.0));
    }
    std::vector<glm::dvec2> found;
    for (int i = 0; i <= points; ++i) {
        const double angle = middle + half * (2.0 * i / points - 1.0);
        found.push_back(circle.center + circle.radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return found;
}

namespace {

// `numbers`: of a hit, or of a sphere that is passed.
QuadraticCurve curve_of(const auto& numbers) {
    QuadraticCurve curve{.number = numbers.number, .lowest_t = -0.5 * numbers.b / numbers.a, .sign = numbers.discriminant_sign};
    const double half = 0.5 * std::sqrt(std::fabs(numbers.discriminant)) / numbers.a;
    curve.lowest = curve.sign > 0 ? -half * half : half * half;
    if (curve.sign >= 0) {
        curve.t1 = numbers.t1;
        curve.t2 = numbers.t2;
    }
    return curve;
}

bool is_finite(const QuadraticCurve& curve) {
    return std::isfinite(curve.lowest_t) && std::isfinite(curve.lowest) && std::isfinite(curve.t1) && std::isfinite(curve.t2);
}

}  // namespace

QuadraticPlot plot_of(const PixelExplanation& explanation, std::int32_t subject) {
    QuadraticPlot plot;
    for (const ExplainedHit& hit : explanation.hits) {
        plot.curves.push_back(curve_of(hit));
        plot.curves.back().first_counts = hit.counts == CountingRoot::t1;
        plot.curves.back().second_counts = hit.counts != CountingRoot::t1;
    }
    for (const SphereOnLine& passed : explanation.passed) plot.curves.push_back(curve_of(passed));
    std::erase_if(plot.curves, [](const QuadraticCurve& curve) { return !is_finite(curve); });
    if (plot.curves.empty()) return plot;
    const auto front = std::ranges::find(plot.curves, subject, &QuadraticCurve::number);
    if (front != plot.curves.end()) std::rotate(plot.curves.begin(), front, front + 1);

    const QuadraticCurve& curve = plot.curves.front();
    double half = std::sqrt(std::fabs(curve.lowest));
    // Of a tangent ray, as much as leads to a picture.
    if (half < 1e-9 * std::fabs(curve.lowest_t) || half == 0.0)
        half = curve.lowest_t == 0.0 ? 1.0 : 0.2 * std::fabs(curve.lowest_t);
    const double reach = 2.3 * half;
    plot.left = curve.lowest_t - reach;
    plot.right = curve.lowest_t + reach;
    // Where the ray begins is worth some room.
    constexpr double most_reaches = 5.0;
    const double margin = 0.25 * reach;
    if (plot.left > -margin && curve.lowest_t < most_reaches * reach) plot.left = -margin;
    if (plot.right < margin && curve.lowest_t > -most_reaches * reach) plot.right = margin;
    plot.shows_origin = plot.left < 0.0 && plot.right > 0.0;
    const double unit = half * half;
    plot.bottom = std::min(curve.lowest, 0.0) - 0.45 * unit;
    plot.top = std::max(curve.lowest, 0.0) + 2.2 * unit;
    return plot;
}

}  // namespace sphereview

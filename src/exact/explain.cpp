#include "exact/explain.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <span>
#include <utility>

#include "base/square_root.hpp"
#include "base/text.hpp"
#include "exact/exact_decision.hpp"
#include "exact/exact_quadratic.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

// The pixel's ray in exact integers.
struct Ray {
    CommonScale scale;
    ExactOrigin origin;       // on the scale
    IntegerVector direction;  // likewise, times `factor`
    Integer square;           // of the direction: A
    Integer factor;           // m; orthographic: 1

    // On a scale that also holds the spheres with these numbers.
    Ray(const Scene& scene, std::span<const std::int32_t> numbers, const Camera& camera, PictureSize size, Pixel pixel)
        : factor(camera.orthographic() ? 1 : size.shorter_side()) {
        scale.include(camera);
        for (const std::int32_t number : numbers) scale.include(scene.spheres[static_cast<std::size_t>(number)]);
        origin = exact_origin(camera, size, pixel, scale);
        direction = exact_direction(camera, size, pixel, scale);
        square = dot(direction, direction);
    }
};

// value * 2^exponent to the nearest double, of two the even one; value has 55 bits or more, and its last stands for all below.
double nearest(const Integer& value, int exponent) {
    constexpr int least_exponent = -1074;  // of a double's last bit
    const auto dropped = static_cast<unsigned>(std::max(static_cast<int>(msb(value)) - 52, least_exponent - exponent));
    Integer kept = value >> dropped;
    const Integer doubled_rest = (value - (kept << dropped)) << 1;
    const Integer one = Integer(1) << dropped;
    if (doubled_rest > one || (doubled_rest == one && bit_test(kept, 0))) ++kept;
    return std::ldexp(kept.convert_to<double>(), exponent + static_cast<int>(dropped));
}

// (x + y sqrt(d)) / z * 2^exponent to the nearest double, z > 0.
double rounded(const Integer& x, const Integer& y, const Integer& d, const Integer& z, int exponent) {
    const int sign = sign_with_root(x, y, d);
    if (sign <= 0) return sign == 0 ? 0.0 : -rounded(-x, -y, d, z, exponent);
    const Integer square = y * y * d;
    for (unsigned more = 64;; more *= 2) {  // bits: the sum may be far smaller than its parts
        Integer rest;
        Integer root = sqrt(Integer(square << 2 * more), rest);
        if (y < 0) root = -root - (rest == 0 ? 0 : 1);
        Integer quotient;
        Integer remainder;
        divide_qr(Integer((x << more) + root), z, quotient, remainder);
        if (quotient <= 0 || msb(quotient) < 55) continue;
        const bool whole = rest == 0 && remainder == 0;
        return nearest(2 * quotient + (whole ? 0 : 1), exponent - static_cast<int>(more) - 1);
    }
}

double rounded(const Integer& x, const Integer& z, int exponent) { return rounded(x, 0, 0, z, exponent); }

// Most spheres are missed by far: for those exact arithmetic need not be asked.
class DoubleFilter {
public:
    DoubleFilter(const Camera& camera, PictureSize size, Pixel pixel)
        : eye_(camera.eye),
          basis_(ray_basis<double>(camera, size)),
          error_scale_(error_scale(filter_condition(camera), double_unit)) {
        if (!basis_.in_range) return;
        ray_ = unit_ray(basis_, size, pixel);
        origin_ = ray_origin(basis_, size, pixel);
    }

    // The discriminant is below 0: the ray passes the centre at a distance above the radius, as hit_bounds() has it.
    bool surely_missed(const Sphere& sphere) const {
        const glm::dvec3 from_eye = sphere.center - eye_;
        const double size = taxicab_length(from_eye) + sphere.radius + basis_.reach;
        if (!basis_.in_range || !std::isfinite(error_scale_) || !(size > smallest_double_size && size < largest_double_size)) {
            return false;
        }
        const glm::dvec3 c = from_eye - origin_;
        const double along = c.x * ray_.x + c.y * ray_.y + c.z * ray_.z;
        const glm::dvec3 p = c - along * ray_;
        return square_root(p.x * p.x + p.y * p.y + p.z * p.z) - sphere.radius > error_scale_ * size;
    }

    bool in_range() const { return basis_.in_range; }

    // How the ray's line passes a sphere, roughly.
    struct Pass {
        double along;  // from the ray's origin to where the line is nearest to the centre; below 0: behind the origin
        double gap;    // between the line and the surface; below 0: it meets the sphere
        double away;   // how far from a hit that looks: the gap as seen from the eye, or in itself where rays are parallel
    };
    Pass pass(const Sphere& sphere) const {
        const glm::dvec3 c = sphere.center - eye_ - origin_;
        const double along = c.x * ray_.x + c.y * ray_.y + c.z * ray_.z;
        const glm::dvec3 p = c - along * ray_;
        const double gap = square_root(p.x * p.x + p.y * p.y + p.z * p.z) - sphere.radius;
        return {along, gap, basis_.orthographic ? gap : gap / along};
    }

private:
    glm::dvec3 eye_;
    RayBasis<double> basis_;
    double error_scale_;
    glm::dvec3 ray_{0.0};
    glm::dvec3 origin_{0.0};  // relative to the eye
};

struct Hit {
    const Sphere* sphere;
    std::int32_t number;
    ExactQuadratic quadratic;
    ExactRoot root;

    // Nearer, or as near and earlier in the file.
    bool operator<(const Hit& other) const {
        const int order = compare(root, other.root);
        return order < 0 || (order == 0 && number < other.number);
    }
};

// The integers belong to f D and to half of b, and to g times the scene: A t'^2 - 2 q.b t' + q.c = 0 with g t = f t'. `out`: a hit,
// or what is passed.
void round_numbers(const ExactQuadratic& q, const Ray& ray, auto& out) {
    const Integer& f = ray.factor;
    const Integer g = ray.origin.factor;
    const int exponent = ray.scale.exponent();
    out.discriminant_sign = q.d.sign();
    out.a = rounded(ray.square, f * f, 2 * exponent);
    out.b = rounded(-2 * q.b, f * g, 2 * exponent);
    out.c = rounded(q.c, g * g, 2 * exponent);
    out.discriminant = rounded(4 * q.d, f * f * g * g, 4 * exponent);
    if (q.d < 0) return;
    out.t1 = rounded(f * q.b, -f, q.d, ray.square * g, 0);
    out.t2 = rounded(f * q.b, f, q.d, ray.square * g, 0);
}

ExplainedHit explain(const Hit& hit, const Ray& ray) {
    const ExactQuadratic& q = hit.quadratic;
    ExplainedHit out;
    out.number = hit.number;
    out.eye = q.c > 0 ? EyeSide::outside : q.c < 0 ? EyeSide::inside : EyeSide::on_surface;
    out.counts = out.eye == EyeSide::outside  ? CountingRoot::t1
                 : out.eye == EyeSide::inside ? CountingRoot::t2_inside
                                              : CountingRoot::t2_surface;
    round_numbers(q, ray, out);
    const Integer g = ray.origin.factor;
    const int exponent = ray.scale.exponent();
    out.t = out.counts == CountingRoot::t1 ? out.t1 : out.t2;
    const IntegerVector center = ray.scale.whole(hit.sphere->center);
    const Integer radius = ray.scale.whole(hit.sphere->radius);
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const Integer x = ray.origin.place[i] * ray.square + ray.direction[i] * q.b;
        const Integer y = hit.root.sign * ray.direction[i];
        out.point[axis] = rounded(x, y, q.d, ray.square * g, exponent);
        out.normal[axis] = rounded(x - center[i] * ray.square * g, y, q.d, ray.square * radius * g, 0);
    }
    return out;
}

// The numbers of the spheres that a pixel's ray may hit, ascending; without lists all that are not hidden.
std::vector<std::int32_t> spheres_to_try(const Scene& scene, const DrawnSpheres& drawn, const CandidateLists* lists, Pixel pixel) {
    std::vector<std::int32_t> numbers;
    if (lists == nullptr) {
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
            if (!scene.spheres[i].hidden) numbers.push_back(static_cast<std::int32_t>(i));
        }
        return numbers;
    }
    numbers = drawn.twins;
    for (const TileLevel& level : lists->levels) {
        for (const Candidate& candidate : lists->at(level, pixel.x, pixel.y)) {
            if (ends_walk(candidate, farthest_hit)) break;
            numbers.push_back(drawn.number(candidate.index));
        }
    }
    std::ranges::sort(numbers);
    return numbers;
}

// The spheres that the ray may pass without a hit, the nearest first, roughly: in front of the eye, and behind it. `most` of each.
struct Passed {
    std::vector<std::int32_t> in_front;
    std::vector<std::int32_t> behind;
};
Passed passed_by(const Scene& scene, const DoubleFilter& filter, std::size_t most) {
    if (most == 0 || !filter.in_range()) return {};
    using Ranked = std::pair<double, std::int32_t>;
    std::vector<Ranked> in_front;
    std::vector<Ranked> behind;
    const auto keep = [most](std::vector<Ranked>& ranked, double away, std::size_t number) {
        if (!(away < std::numeric_limits<double>::infinity()) || (ranked.size() == most && away >= ranked.back().first)) return;
        const Ranked one{away, static_cast<std::int32_t>(number)};
        ranked.insert(std::ranges::upper_bound(ranked, one), one);
        if (ranked.size() > most) ranked.pop_back();
    };
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        if (scene.spheres[i].hidden) continue;
        const DoubleFilter::Pass pass = filter.pass(scene.spheres[i]);
        // What rounding leaves open is tried as both.
        if (pass.along > 0.0 && pass.gap > -1e-9 * scene.spheres[i].radius) keep(in_front, pass.away, i);
        if (pass.along < 0.0 && pass.gap <= 1e-9 * scene.spheres[i].radius) keep(behind, -pass.along, i);
    }
    Passed passed;
    for (const auto& [away, number] : in_front) passed.in_front.push_back(number);
    for (const auto& [away, number] : behind) passed.behind.push_back(number);
    return passed;
}

constexpr const char* unshown_small = "too small for a double to show; decided exactly";
constexpr const char* unshown_large = "too large for a double to show; decided exactly";

// A number whose sign (-1, 0, 1) is known exactly, also where a double has become 0 or infinite: what is shown must not
// contradict what was decided.
std::string number_in_words(double value, int sign) {
    const std::string side = sign > 0 ? "(above 0, " : "(below 0, ";
    if (std::isinf(value)) return (value > 0.0 ? "(above 0, " : "(below 0, ") + std::string(unshown_large) + ")";
    if (value == 0.0 && sign != 0) return side + unshown_small + ")";
    return shortest(value + 0.0);  // -0 becomes 0
}

}  // namespace

PixelExplanation explain_pixel(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size, Pixel pixel,
                               const CandidateLists* lists, std::size_t most_hits, std::size_t most_passed) {
    PixelExplanation out;
    std::vector<std::int32_t> numbers = spheres_to_try(scene, drawn, lists, pixel);
    const auto all = static_cast<std::int64_t>(scene.spheres.size());
    out.hidden = all - static_cast<std::int64_t>(drawn.size() - drawn.gone.size() + drawn.twins.size());
    out.elsewhere = all - out.hidden - static_cast<std::int64_t>(numbers.size());
    const DoubleFilter filter(camera, size, pixel);
    out.missed = static_cast<std::int64_t>(std::erase_if(
        numbers, [&](std::int32_t number) { return filter.surely_missed(scene.spheres[static_cast<std::size_t>(number)]); }));

    const Passed passed = passed_by(scene, filter, most_passed);
    std::vector<std::int32_t> scaled = numbers;
    for (const auto* more : {&passed.in_front, &passed.behind}) scaled.insert(scaled.end(), more->begin(), more->end());
    const Ray ray(scene, scaled, camera, size, pixel);
    out.projection = camera.projection;
    out.origin = camera.eye;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        out.direction[axis] = rounded(ray.direction[i], ray.factor, ray.scale.exponent());
        if (camera.orthographic()) out.origin[axis] = rounded(ray.origin.place[i], ray.origin.factor, ray.scale.exponent());
    }

    std::set<Hit> hits;  // no more than are explained: each takes kilobytes
    for (const std::int32_t number : numbers) {
        const Sphere& sphere = scene.spheres[static_cast<std::size_t>(number)];
        ExactQuadratic quadratic(sphere, ray.origin, ray.direction, ray.square, ray.scale);
        auto root = smallest_positive_root(quadratic);
        if (!root) {
            ++(quadratic.d < 0 ? out.missed : out.behind);
            continue;
        }
        hits.insert({&sphere, number, std::move(quadratic), *std::move(root)});
        if (hits.size() <= most_hits) continue;
        hits.erase(std::prev(hits.end()));
        ++out.farther;
    }
    const Hit* before = nullptr;
    for (const Hit& hit : hits) {
        out.hits.push_back(explain(hit, ray));
        out.hits.back().projection = camera.projection;
        out.hits.back().as_near_as_last = before != nullptr && compare(before->root, hit.root) == 0;
        before = &hit;
    }
    for (const bool in_front : {true, false}) {
        for (const std::int32_t number : in_front ? passed.in_front : passed.behind) {
            const ExactQuadratic quadratic(scene.spheres[static_cast<std::size_t>(number)], ray.origin, ray.direction, ray.square,
                                           ray.scale);
            if ((quadratic.d < 0) != in_front || smallest_positive_root(quadratic)) continue;
            out.passed.emplace_back().number = number;
            round_numbers(quadratic, ray, out.passed.back());
        }
    }
    out.level = decision_level(scene, drawn, camera, size, pixel, lists);
    return out;
}

std::string called(const Scene& scene, std::int32_t number) {
    if (number == visible_background) return "the background";
    const auto name = scene.names.find(static_cast<std::uint32_t>(number));
    return "sphere " + std::to_string(number) + (name == scene.names.end() ? "" : " " + in_quotes(name->second));
}

std::string vector_in_words(const glm::dvec3& v) {
    const auto part = [](double value) {
        return std::isinf(value) ? (value > 0.0 ? "" : "-") + std::string("(too large for a double)") : shortest(value + 0.0);
    };
    return "(" + part(v.x) + ", " + part(v.y) + ", " + part(v.z) + ")";
}

std::string origin_in_words(const PixelExplanation& explanation) {
    const bool parallel = explanation.projection == Projection::orthographic;
    return "O = " + vector_in_words(explanation.origin) + (parallel ? "  the pixel's place in the plane of the eye" : "  the eye");
}

std::string direction_in_words(const PixelExplanation& explanation) {
    const bool parallel = explanation.projection == Projection::orthographic;
    return "D = " + vector_in_words(explanation.direction) +
           (parallel ? "  the same for all pixels" : "  through the pixel's centre");
}

const char* behind_in_words(const PixelExplanation& explanation) {
    return explanation.projection == Projection::orthographic ? "behind where the ray begins" : "behind the eye";
}

const char* why(const ExplainedHit& hit) {
    const bool tangent = hit.discriminant_sign == 0;
    if (hit.projection == Projection::orthographic && !tangent) {
        switch (hit.counts) {
            case CountingRoot::t1:
                return "both roots are positive (c > 0: the ray begins outside, and b < 0): the smaller, t1, counts";
            case CountingRoot::t2_inside: return "c < 0: the ray begins inside the sphere, so t1 < 0 < t2, and t2 counts";
            case CountingRoot::t2_surface: return "c = 0: the ray begins on the surface; t1 = 0 is not positive, and t2 counts";
        }
    }
    switch (hit.counts) {
        case CountingRoot::t1:
            return tangent ? "one root, positive: the ray is tangent, and t1 = t2 counts"
                           : "both roots are positive (c > 0: the eye is outside, and b < 0): the smaller, t1, counts";
        case CountingRoot::t2_inside: return "c < 0: the eye is inside the sphere, so t1 < 0 < t2, and t2 counts";
        case CountingRoot::t2_surface: return "c = 0: the eye is on the surface; t1 = 0 is not positive, and t2 counts";
    }
    return "";
}

const char* level_in_words(DecisionLevel level) {
    switch (level) {
        case DecisionLevel::in_float: return "float arithmetic, with its proven error bound, is enough to decide this pixel";
        case DecisionLevel::in_double: return "too close for float arithmetic; double, with its proven error bound, decides";
        case DecisionLevel::exactly: return "too close for float and double; only exact arithmetic decides";
    }
    return "";
}

HitInWords in_words(const ExplainedHit& hit) {
    const int c_sign = hit.eye == EyeSide::outside ? 1 : hit.eye == EyeSide::inside ? -1 : 0;
    const int b_sign = c_sign >= 0 ? -1 : 0;  // a hit in front of the eye, or nothing known
    const bool too_near = hit.discriminant_sign > 0 && hit.t1 == hit.t2 && hit.t2 != 0.0 && std::isfinite(hit.t2);
    return {
        .a = number_in_words(hit.a, 1),
        .b = number_in_words(hit.b, b_sign),
        .c = number_in_words(hit.c, c_sign),
        .discriminant = number_in_words(hit.discriminant, hit.discriminant_sign),
        .roots = hit.discriminant_sign > 0 ? "> 0: two roots" : "= 0 exactly: tangent, one root",
        .t1 = number_in_words(hit.t1, c_sign),
        .t2 = number_in_words(hit.t2, 1) + (too_near ? "  (larger than t1 by too little for a double to show)" : ""),
        .t = number_in_words(hit.t, 1),
        .point = vector_in_words(hit.point),
        .normal = vector_in_words(hit.normal),
    };
}

}  // namespace sphereview

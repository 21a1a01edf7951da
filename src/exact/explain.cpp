#include "exact/explain.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <span>

#include "exact/exact_decision.hpp"
#include "exact/exact_quadratic.hpp"

namespace sphereview {

namespace {

using Float = boost::multiprecision::cpp_bin_float_100;  // wide enough that only the last rounding, to double, shows
using FloatVector = std::array<Float, 3>;

// The pixel's ray, exact and in wide floating point.
struct Ray {
    CommonScale scale;
    IntegerVector eye;
    IntegerVector exact;  // m D on the scale
    FloatVector origin;
    FloatVector direction;  // D
    Float m;

    // On a scale that also holds the spheres with these numbers.
    Ray(const Scene& scene, std::span<const std::int32_t> numbers, const Camera& camera, PictureSize size, Pixel pixel)
        : m(size.shorter_side()) {
        scale.include(camera);
        for (const std::int32_t number : numbers) scale.include(scene.spheres[static_cast<std::size_t>(number)]);
        eye = scale.whole(camera.eye);
        exact = exact_direction(camera, size, pixel, scale);
        for (std::size_t i = 0; i < 3; ++i) {
            origin[i] = unscaled(eye[i], 1);
            direction[i] = unscaled(exact[i], 1) / m;
        }
    }

    // A product of `degree` scaled factors as it is in the scene.
    Float unscaled(const Integer& value, int degree) const { return ldexp(Float(value), degree * scale.exponent()); }
};

glm::dvec3 rounded(const FloatVector& v) {
    return {v[0].convert_to<double>(), v[1].convert_to<double>(), v[2].convert_to<double>()};
}

// Most spheres are missed by far: for those exact arithmetic need not be asked.
class DoubleFilter {
public:
    DoubleFilter(const Camera& camera, PictureSize size, Pixel pixel)
        : eye_(camera.eye), frame_(ray_basis<double>(camera, size)), error_scale_(error_scale(ray_condition(camera), double_unit)) {
        if (frame_.in_range) ray_ = unit_ray(frame_, size, pixel);
    }

    // The discriminant is below 0: the ray passes the centre at a distance above the radius, as hit_bounds() has it.
    bool surely_missed(const Sphere& sphere) const {
        const glm::dvec3 c = sphere.center - eye_;
        const double size = std::fabs(c.x) + std::fabs(c.y) + std::fabs(c.z) + sphere.radius;
        if (!frame_.in_range || !std::isfinite(error_scale_) || !(size > smallest_double_size && size < largest_double_size)) {
            return false;
        }
        const double along = c.x * ray_.x + c.y * ray_.y + c.z * ray_.z;
        const glm::dvec3 p = c - along * ray_;
        return std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z) - sphere.radius > error_scale_ * size;
    }

private:
    glm::dvec3 eye_;
    RayBasis<double> frame_;
    double error_scale_;
    glm::dvec3 ray_{0.0};
};

struct Hit {
    const Sphere* sphere;
    std::int32_t number;
    ExactQuadratic quadratic;
    ExactRoot root;
};

ExplainedHit explain(const Hit& hit, const Ray& ray) {
    const ExactQuadratic& q = hit.quadratic;
    ExplainedHit out;
    out.number = hit.number;
    out.eye = q.c > 0 ? EyeSide::outside : q.c < 0 ? EyeSide::inside : EyeSide::on_surface;
    out.discriminant_sign = q.d.sign();
    out.counts = out.eye == EyeSide::outside  ? CountingRoot::t1
                 : out.eye == EyeSide::inside ? CountingRoot::t2_inside
                                              : CountingRoot::t2_surface;
    // The integers belong to m D and to half of b: A t'^2 - 2 q.b t' + q.c = 0 with t = m t'.
    const Integer exact_a = dot(ray.exact, ray.exact);
    out.a = (ray.unscaled(exact_a, 2) / (ray.m * ray.m)).convert_to<double>();
    out.b = (-2 * ray.unscaled(q.b, 2) / ray.m).convert_to<double>();
    out.c = ray.unscaled(q.c, 2).convert_to<double>();
    out.discriminant = (4 * ray.unscaled(q.d, 4) / (ray.m * ray.m)).convert_to<double>();
    const Float root = sqrt(Float(q.d));
    // The root without cancellation, the other one from their product c / A.
    const Float large = q.b >= 0 ? Float(Float(q.b) + root) : Float(Float(q.b) - root);
    const Float first = large / Float(exact_a) * ray.m;
    const Float second = large == 0 ? Float(0) : Float(Float(q.c) / large * ray.m);
    const Float t1 = std::min(first, second);
    const Float t2 = std::max(first, second);
    const Float t = out.counts == CountingRoot::t1 ? t1 : t2;
    out.t1 = t1.convert_to<double>();
    out.t2 = t2.convert_to<double>();
    out.t = t.convert_to<double>();
    FloatVector point;
    FloatVector normal;
    const glm::dvec3& center = hit.sphere->center;
    for (std::size_t i = 0; i < 3; ++i) {
        point[i] = ray.origin[i] + t * ray.direction[i];
        normal[i] = (point[i] - Float(center[static_cast<int>(i)])) / Float(hit.sphere->radius);
    }
    out.point = rounded(point);
    out.normal = rounded(normal);
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

}  // namespace

PixelExplanation explain_pixel(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel) {
    return explain_pixel(scene, drawn_spheres(scene, camera), camera, size, pixel, nullptr);
}

PixelExplanation explain_pixel(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size, Pixel pixel,
                               const CandidateLists* lists) {
    PixelExplanation out;
    std::vector<std::int32_t> numbers = spheres_to_try(scene, drawn, lists, pixel);
    const auto all = static_cast<std::int64_t>(scene.spheres.size());
    out.hidden = all - static_cast<std::int64_t>(drawn.size() - drawn.gone.size() + drawn.twins.size());
    out.elsewhere = all - out.hidden - static_cast<std::int64_t>(numbers.size());
    const DoubleFilter filter(camera, size, pixel);
    out.missed = static_cast<std::int64_t>(std::erase_if(
        numbers, [&](std::int32_t number) { return filter.surely_missed(scene.spheres[static_cast<std::size_t>(number)]); }));

    const Ray ray(scene, numbers, camera, size, pixel);
    out.origin = rounded(ray.origin);
    out.direction = rounded(ray.direction);

    std::vector<Hit> hits;
    for (const std::int32_t number : numbers) {
        const Sphere& sphere = scene.spheres[static_cast<std::size_t>(number)];
        ExactQuadratic quadratic(sphere, ray.eye, ray.exact, ray.scale);
        if (auto root = smallest_positive_root(quadratic)) {
            hits.push_back({&sphere, number, std::move(quadratic), *std::move(root)});
        } else {
            ++(quadratic.d < 0 ? out.missed : out.behind);
        }
    }
    std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return compare(a.root, b.root) < 0; });
    for (std::size_t i = 0; i < hits.size(); ++i) {
        out.hits.push_back(explain(hits[i], ray));
        out.hits.back().as_near_as_last = i > 0 && compare(hits[i - 1].root, hits[i].root) == 0;
    }
    out.level = decision_level(scene, drawn, camera, size, pixel, lists);
    return out;
}

}  // namespace sphereview

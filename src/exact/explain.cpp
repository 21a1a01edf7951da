#include "exact/explain.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "exact/drawn.hpp"
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

    Ray(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel) : m(size.shorter_side()) {
        scale.include(camera);
        for (const Sphere& sphere : scene.spheres) scale.include(sphere);
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

}  // namespace

PixelExplanation explain_pixel(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel) {
    const Ray ray(scene, camera, size, pixel);
    const DoubleFilter filter(camera, size, pixel);
    PixelExplanation out;
    out.origin = rounded(ray.origin);
    out.direction = rounded(ray.direction);

    std::vector<Hit> hits;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const Sphere& sphere = scene.spheres[i];
        if (sphere.hidden) {
            ++out.hidden;
            continue;
        }
        if (filter.surely_missed(sphere)) {
            ++out.missed;
            continue;
        }
        ExactQuadratic quadratic(sphere, ray.eye, ray.exact, ray.scale);
        if (auto root = smallest_positive_root(quadratic)) {
            hits.push_back({&sphere, static_cast<std::int32_t>(i), std::move(quadratic), *std::move(root)});
        } else {
            ++(quadratic.d < 0 ? out.missed : out.behind);
        }
    }
    std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return compare(a.root, b.root) < 0; });
    for (std::size_t i = 0; i < hits.size(); ++i) {
        out.hits.push_back(explain(hits[i], ray));
        out.hits.back().as_near_as_last = i > 0 && compare(hits[i - 1].root, hits[i].root) == 0;
    }
    const DrawnSpheres drawn = drawn_spheres(scene, camera);
    out.level = decision_level(scene, drawn, camera, size, pixel);
    return out;
}

}  // namespace sphereview

// The same claims for the arithmetic of the CPU: float and double as they are, with the code and the inputs of the renderer
// and of the resolver; and the condition of the rays.
#include <gtest/gtest.h>

#include <cstdio>

#include "exact/drawn.hpp"
#include "exact/exact_decision.hpp"
#include "exact/rays.hpp"
#include "proof/filter_model.hpp"
#include "proof/trial.hpp"
#include "proof/truth.hpp"

namespace sphereview {

namespace {

template <typename Real>
Vector<Real> vector(const glm::vec<3, Real>& v) {
    return {v.x, v.y, v.z};
}

struct Bounds {
    double low;
    double high;
};

// In scene units, with `factor` times the bound.
Bounds bounds_in_float(const Trial& trial, EyeSide side, double factor) {
    Scene scene;
    scene.camera = trial.camera;
    scene.spheres = {trial.sphere};
    const DrawnSpheres drawn = drawn_spheres(scene);
    const FloatView view = float_view(trial.camera, trial.size, drawn.scale, float_unit);
    EXPECT_FALSE(view.all_doubtful);
    EXPECT_EQ(drawn.side(0), side);
    const RayCoefficients k = ray_coefficients(trial.size, trial.pixel);
    const glm::vec4& sphere = drawn.center_radius[0];
    const FilterInputs<float> inputs = {vector(view.rays.forward),    vector(view.rays.right),
                                        vector(view.rays.up),         static_cast<float>(k.across),
                                        static_cast<float>(k.upward), {sphere.x, sphere.y, sphere.z},
                                        std::fabs(sphere.w),          view.error_scale * static_cast<float>(factor)};
    const HitBounds<float> hit = run_filter(inputs, side);
    return {std::ldexp(static_cast<double>(hit.low), -drawn.scale), std::ldexp(static_cast<double>(hit.high), -drawn.scale)};
}

Bounds bounds_in_double(const Trial& trial, EyeSide side, double factor) {
    const RayBasis<double> frame = ray_basis<double>(trial.camera, trial.size);
    const RayCoefficients k = ray_coefficients(trial.size, trial.pixel);
    const FilterInputs<double> inputs = {vector(frame.forward),
                                         vector(frame.right),
                                         vector(frame.up),
                                         static_cast<double>(k.across),
                                         static_cast<double>(k.upward),
                                         vector(trial.sphere.center - trial.camera.eye),
                                         trial.sphere.radius,
                                         error_scale(ray_condition(trial.camera), double_unit) * factor};
    const HitBounds<double> hit = run_filter(inputs, side);
    return {hit.low, hit.high};
}

template <EyeSide side, typename Real>
HitBounds<Real> bounds_from(const glm::vec<3, Real>& c, Real r, Real w, const glm::vec<3, Real>& ray) {
    return hit_bounds<side>(c.x, c.y, c.z, r, w, ray.x, ray.y, ray.z);
}

// Of a parallel ray.
template <typename Real>
HitBounds<Real> parallel_bounds(const Trial& trial, const RayBasis<Real>& frame, const glm::vec<3, Real>& center, Real r,
                                Real scale, EyeSide side) {
    EXPECT_TRUE(frame.in_range);
    const Real w = scale * (std::fabs(center.x) + std::fabs(center.y) + std::fabs(center.z) + r + frame.reach);
    const glm::vec<3, Real> c = center - ray_origin(frame, trial.size, trial.pixel);
    const glm::vec<3, Real> ray = unit_ray(frame, trial.size, trial.pixel);
    return side == EyeSide::outside ? bounds_from<EyeSide::outside>(c, r, w, ray) : bounds_from<EyeSide::in_plane>(c, r, w, ray);
}

Bounds parallel_bounds_in_float(const Trial& trial, EyeSide, double factor) {
    Scene scene;
    scene.camera = trial.camera;
    scene.spheres = {trial.sphere};
    const DrawnSpheres drawn = drawn_spheres(scene);
    const FloatView view = float_view(trial.camera, trial.size, drawn.scale, float_unit);
    const glm::vec4& sphere = drawn.center_radius[0];
    const HitBounds<float> hit = parallel_bounds(trial, view.rays, glm::vec3(sphere), std::fabs(sphere.w),
                                                 view.error_scale * static_cast<float>(factor), drawn.side(0));
    return {std::ldexp(static_cast<double>(hit.low), -drawn.scale), std::ldexp(static_cast<double>(hit.high), -drawn.scale)};
}

Bounds parallel_bounds_in_double(const Trial& trial, EyeSide, double factor) {
    const double scale = error_scale(orthographic_condition, double_unit) * factor;
    const HitBounds<double> hit =
        parallel_bounds(trial, ray_basis<double>(trial.camera, trial.size), trial.sphere.center - trial.camera.eye,
                        trial.sphere.radius, scale, EyeSides(trial.camera)(trial.sphere));
    return {hit.low, hit.high};
}

// The truth is rounded to double itself, by which a bound of 2^-53 units must not be judged: half a unit of slack.
bool holds(const Truth& truth, const Bounds& bounds) {
    const double slack = 0x1p-53 * truth.distance;
    return claims_hold(truth, bounds.low - slack, bounds.high + slack);
}

template <typename BoundsOf>
void check(const char* name, double unit, int trials, const BoundsOf& bounds_of, bool parallel = false) {
    Random random(test_seed());
    double largest = 1.0 / 64.0;  // the largest part of the bound that a trial broke
    for (int i = 0; i < trials; ++i) {
        const Trial in_perspective = random_trial(random, unit);
        const Trial trial = parallel ? with_parallel_rays(in_perspective) : in_perspective;
        if (camera_fault(trial.camera)) continue;
        const Truth truth = true_hit(trial);
        ASSERT_TRUE(holds(truth, bounds_of(trial, truth.side, 1.0))) << "trial " << i << '\n' << to_string(trial);
        const EyeSide eye = parallel ? EyeSides(trial.camera)(trial.sphere) : eye_side(trial.sphere, trial.camera.eye);
        ASSERT_EQ(origin_side(trial.sphere, eye, trial.camera, trial.size, trial.pixel), truth.side) << "trial " << i << '\n'
                                                                                                     << to_string(trial);
        while (!holds(truth, bounds_of(trial, truth.side, largest * 1.01))) largest *= 1.01;
    }
    std::printf("%s, %d trials: the largest error found is %.3f of the bound\n", name, trials, largest);
    testing::Test::RecordProperty("largest_error", std::to_string(largest));
    EXPECT_GT(largest, 1.0 / 64.0) << "too small a bound must be noticed";
}

TEST(Arithmetic, FloatKeepsItsBound) { check("float", float_unit, trial_count(50000), bounds_in_float); }

TEST(Arithmetic, DoubleKeepsItsBound) { check("double", double_unit, trial_count(50000), bounds_in_double); }

TEST(Arithmetic, FloatKeepsItsBoundForParallelRays) {
    check("float, parallel rays", float_unit, trial_count(30000), parallel_bounds_in_float, true);
}

TEST(Arithmetic, DoubleKeepsItsBoundForParallelRays) {
    check("double, parallel rays", double_unit, trial_count(30000), parallel_bounds_in_double, true);
}

TEST(Arithmetic, NoRayExceedsItsCondition) {
    Random random(test_seed());
    double largest = 0.0;
    for (int i = 0; i < trial_count(20000); ++i) {
        const Trial trial = random_trial(random, double_unit);
        const double part = true_hit(trial).condition / ray_condition(trial.camera);
        ASSERT_LE(part, 1.0) << "trial " << i << '\n' << to_string(trial);
        largest = std::max(largest, part);
    }
    std::printf("the largest condition of a ray is %.3f of kappa\n", largest);
    EXPECT_GT(largest, 0.9);
}

}  // namespace

}  // namespace sphereview

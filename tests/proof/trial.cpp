#include "proof/trial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>
#include <sstream>

#include "exact/filter.hpp"
#include "exact/rays.hpp"
#include "support/trials.hpp"

namespace sphereview {

namespace {

double uniform(Random& random, double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
int whole(Random& random, int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }
bool chance(Random& random, double probability) { return uniform(random, 0.0, 1.0) < probability; }
double power_of_two(Random& random, double low, double high) { return std::exp2(uniform(random, low, high)); }

glm::dvec3 random_direction(Random& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3{normal(random), normal(random), normal(random)});
}

glm::dvec3 perpendicular_to(Random& random, const glm::dvec3& n) { return glm::normalize(glm::cross(n, random_direction(random))); }

// The row or column whose coefficient, 2 x + 1 - side, comes nearest to `wanted`.
int nearest_pixel(double wanted, int side) {
    return static_cast<int>(std::clamp(std::floor((wanted + side) * 0.5), 0.0, side - 1.0));
}

// A quarter of the cameras look along an axis, so that most terms are 0 and |x| + |y| + |z| is no longer than the vector.
// Half have the screen's centre far off the axis, and most of those a pixel where the long terms of the ray cancel.
void aim(Random& random, Trial& trial) {
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    if (chance(random, 0.75)) {
        right = random_direction(random);
        up = perpendicular_to(random, right);
    }
    const glm::dvec3 normal = glm::cross(right, up);
    if (chance(random, 0.25)) up = up * (1.0 + uniform(random, -9e-7, 9e-7)) + right * uniform(random, -9e-7, 9e-7);
    const double edge = power_of_two(random, -8.0, 8.0);
    trial.size = {whole(random, 1, 3000), whole(random, 1, 3000)};
    trial.pixel = {whole(random, 0, trial.size.width - 1), whole(random, 0, trial.size.height - 1)};

    glm::dvec3 axis = normal * power_of_two(random, -2.0, 2.0);
    if (chance(random, 0.5)) {
        const double shorter = trial.size.shorter_side();
        const double x = uniform(random, -1.0, 1.0) * trial.size.width / shorter;
        const double y = uniform(random, -1.0, 1.0) * trial.size.height / shorter;
        const glm::dvec3 in_plane = x * right + y * up;
        axis = in_plane + normal * (glm::length(in_plane) / power_of_two(random, 0.0, 6.69));
        if (chance(random, 0.75)) {
            trial.pixel.x =
                std::clamp(nearest_pixel(-x * shorter, trial.size.width) + whole(random, -1, 1), 0, trial.size.width - 1);
            trial.pixel.y =
                std::clamp(nearest_pixel(y * shorter, trial.size.height) + whole(random, -1, 1), 0, trial.size.height - 1);
        }
    }
    if (chance(random, 0.5)) trial.camera.eye = random_direction(random) * power_of_two(random, -4.0, 4.0) * edge;
    trial.camera.center = trial.camera.eye + axis * edge;
    trial.camera.right = right * edge;
    trial.camera.up = up * edge;
}

glm::dvec3 approximate_ray(const Trial& trial) {
    const RayCoefficients k = ray_coefficients(trial.size, trial.pixel);
    const double m = trial.size.shorter_side();
    const Camera& camera = trial.camera;
    return glm::normalize((camera.center - camera.eye) * m + static_cast<double>(k.across) * camera.right +
                          static_cast<double>(k.upward) * camera.up);
}

// Whole numbers whose length is whole, too: the eye lies exactly on the surface.
void put_on_surface(Random& random, Trial& trial, double size) {
    static constexpr std::array<std::array<double, 4>, 6> known = {
        {{0, 0, 1, 1}, {0, 3, 4, 5}, {1, 2, 2, 3}, {2, 3, 6, 7}, {4, 4, 7, 9}, {6, 6, 7, 11}}};
    std::array<double, 4> chosen = known.at(static_cast<std::size_t>(whole(random, 0, known.size() - 1)));
    std::shuffle(chosen.begin(), chosen.begin() + 3, random);
    const double scale = std::exp2(std::floor(std::log2(size)));
    for (double& component : chosen) component *= chance(random, 0.5) ? scale : -scale;
    trial.camera.center -= trial.camera.eye;
    trial.camera.eye = glm::dvec3{0.0};
    trial.sphere.center = {chosen[0], chosen[1], chosen[2]};
    trial.sphere.radius = std::fabs(chosen[3]);
}

}  // namespace

Trial random_trial(Random& random, double unit) {
    Trial trial;
    do {
        trial = {};
        aim(random, trial);
    } while (camera_fault(trial.camera) || ray_condition(trial.camera) > largest_float_condition);

    const glm::dvec3 n = approximate_ray(trial);
    const double size = power_of_two(random, -12.0, 12.0);
    const double bound = error_scale(ray_condition(trial.camera), unit) * size;
    const double few_bounds = uniform(random, -4.0, 4.0) * bound;
    const double fraction = chance(random, 0.5) ? uniform(random, 0.0, 1.0) : power_of_two(random, -16.0, 0.0);
    double along = size * uniform(random, -0.2, 1.0);
    double aside = size * fraction;
    double radius = size * uniform(random, 0.01, 1.0);

    trial.awkwardness = static_cast<Awkwardness>(whole(random, 0, static_cast<int>(Awkwardness::count) - 1));
    switch (trial.awkwardness) {
        case Awkwardness::silhouette: radius = aside + few_bounds; break;
        case Awkwardness::beside_eye:
            along = few_bounds;
            radius = chance(random, 0.5) ? aside * uniform(random, 0.5, 1.0) : aside - 0.1 * few_bounds;
            break;
        case Awkwardness::inside: radius = std::hypot(along, aside) * (1.0 + power_of_two(random, -12.0, 4.0)); break;
        case Awkwardness::near_surface:
            radius = std::hypot(along, aside) * (1.0 + (chance(random, 0.5) ? 1.0 : -1.0) * power_of_two(random, -45.0, -8.0));
            break;
        case Awkwardness::through_center:
            aside = chance(random, 0.5) ? 0.0 : std::fabs(few_bounds);
            radius = chance(random, 0.5) ? bound * uniform(random, 0.0, 8.0) : size * fraction;
            break;
        default: break;
    }
    trial.sphere.center = trial.camera.eye + along * n + aside * perpendicular_to(random, n);
    trial.sphere.radius = radius > 0.0 ? radius : bound;
    if (trial.awkwardness == Awkwardness::on_surface) put_on_surface(random, trial, size);
    return trial;
}

Trial with_parallel_rays(Trial trial) {
    const glm::dvec3 n = approximate_ray(trial);
    const RayCoefficients k = ray_coefficients(trial.size, trial.pixel);
    const double m = trial.size.shorter_side();
    Camera& camera = trial.camera;
    camera.projection = Projection::orthographic;
    camera.center = camera.eye + glm::length(camera.center - camera.eye) * n;
    trial.sphere.center += static_cast<double>(k.across) / m * camera.right + static_cast<double>(k.upward) / m * camera.up;
    return trial;
}

std::string to_string(const Trial& trial) {
    std::ostringstream text;
    text << std::hexfloat;
    const auto add = [&](const char* name, const glm::dvec3& v) { text << name << ' ' << v.x << ' ' << v.y << ' ' << v.z << '\n'; };
    text << "awkwardness " << static_cast<int>(trial.awkwardness) << '\n';
    add("eye", trial.camera.eye);
    add("center", trial.camera.center);
    add("right", trial.camera.right);
    add("up", trial.camera.up);
    text << "size " << trial.size.width << 'x' << trial.size.height << " pixel " << trial.pixel.x << ',' << trial.pixel.y << '\n';
    add("sphere", trial.sphere.center);
    text << "radius " << trial.sphere.radius << '\n';
    return text.str();
}

std::uint64_t test_seed() {
    const std::uint64_t seed = test::number_from_environment("SPHEREVIEW_SEED", 1);
    std::cout << "SPHEREVIEW_SEED=" << seed << '\n';
    testing::Test::RecordProperty("seed", std::to_string(seed));
    return seed;
}

int trial_count(int in_release) {
#ifdef NDEBUG
    return in_release;
#else
    return in_release / 20;
#endif
}

}  // namespace sphereview

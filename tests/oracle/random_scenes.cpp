#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>

#include "oracle/scenes.hpp"
#include "support/trials.hpp"

namespace sphereview::oracle {

namespace {

std::string named(const char* kind, std::uint64_t seed) {
    return std::string(kind) + ", SPHEREVIEW_SEED=" + std::to_string(oracle::seed()) + ", trial " + std::to_string(seed);
}

Random random_of(const char* kind, std::uint64_t seed) {
    return Random(oracle::seed() * 1000003 + seed * 31 + static_cast<std::uint64_t>(kind[0]));
}

glm::dvec3 unit_vector(Random& random) {
    for (;;) {
        const glm::dvec3 v = random.in_cube(1.0);
        const double square = glm::dot(v, v);
        if (square > 0.01 && square <= 1.0) return v / std::sqrt(square);
    }
}

PictureSize random_size(Random& random) {
    if (random.chance(0.05)) return {1, random.whole(1, 512)};
    if (random.chance(0.05)) return {random.whole(1, 512), 1};
    return {random.whole(1, 64), random.whole(1, 64)};
}

// Where a pixel's ray goes, nearly.
glm::dvec3 ray_of(const Camera& camera, PictureSize size, Random& random) {
    const auto [across, upward] = ray_coefficients(size, {random.whole(0, size.width - 1), random.whole(0, size.height - 1)});
    const double side = size.shorter_side();
    return camera.center - camera.eye + static_cast<double>(across) / side * camera.right +
           static_cast<double>(upward) / side * camera.up;
}

double nudged(double value, int steps) {
    for (; steps > 0; --steps) value = std::nextafter(value, HUGE_VAL);
    for (; steps < 0; ++steps) value = std::nextafter(value, -HUGE_VAL);
    return value;
}

// Next to `value`: the same, some steps off, or off by any small part.
double beside(double value, Random& random) {
    switch (random.whole(0, 3)) {
        case 0: return value;
        case 1: return nudged(value, random.whole(-2, 2));
        case 2: return value * (1.0 + random.of_size(0x1p-52, 0x1p-12));
        default: return value * (1.0 - random.of_size(0x1p-52, 0x1p-12));
    }
}

Color random_color(Random& random) { return {static_cast<std::uint8_t>(random.bits()), 128, 255}; }

Sphere random_sphere(const Camera& camera, PictureSize size, double scale, Random& random) {
    const glm::dvec3 toward = ray_of(camera, size, random);
    Sphere sphere;
    sphere.color = random_color(random);
    const double distance = scale * random.of_size(0.05, 50.0);
    if (random.chance(0.1)) {
        sphere.center = camera.eye + random.in_cube(scale);
        sphere.radius = scale * random.of_size(0.01, 3.0);
    } else {
        const double sign = random.chance(0.06) ? -1.0 : 1.0;
        sphere.center = camera.eye + sign * distance / glm::length(toward) * toward + random.in_cube(0.3 * distance);
        sphere.radius = distance * random.of_size(random.chance(0.2) ? 1e-4 : 0.02, random.chance(0.1) ? 1.5 : 0.4);
    }
    return sphere;
}

}  // namespace

std::uint64_t seed() { return test::number_from_environment("SPHEREVIEW_SEED", 20240229); }

bool is_sampled(std::size_t index) { return !test::is_sanitized || index % 10 == 0; }

Camera random_camera(Random& random, double scale) {
    for (;;) {
        Camera camera;
        camera.eye = random.chance(0.3) ? glm::dvec3(0.0) : random.in_cube(scale * random.of_size(0.01, 1000.0));
        glm::dvec3 forward(0.0, 0.0, 1.0);
        glm::dvec3 right(1.0, 0.0, 0.0);
        if (!random.chance(0.3)) {
            forward = unit_vector(random);
            right = glm::normalize(glm::cross(unit_vector(random), forward));
        }
        const glm::dvec3 up = glm::cross(forward, right);
        const double distance = scale * random.of_size(0.1, 10.0);
        const double edge = distance * random.of_size(random.chance(0.1) ? 1e-3 : 0.1, random.chance(0.1) ? 100.0 : 3.0);
        const double shift = random.chance(0.5) ? 0.0 : edge * random.of_size(0.01, random.chance(0.2) ? 1e4 : 4.0);
        camera.center = camera.eye + distance * forward + shift * random.between(-1.0, 1.0) * right;
        camera.center += shift * random.between(-1.0, 1.0) * up;
        camera.right = edge * right;
        camera.up = edge * up;
        // As far from perpendicular and equally long as a camera may be.
        if (random.chance(0.2)) camera.up += random.in_cube(4e-7 * edge);
        if (!camera_fault(camera)) return camera;
    }
}

Trial random_trial(std::uint64_t seed) {
    Random random = random_of("any", seed);
    Trial trial{named("random", seed), {}, random_size(random)};
    const double scale = random.chance(0.7) ? 100.0 : random.of_size(1e-12, 1e12);
    if (!random.chance(0.2)) trial.scene.camera = random_camera(random, scale);
    for (int count = random.whole(1, 40); count > 0; --count) {
        trial.scene.spheres.push_back(random_sphere(trial.scene.camera, trial.size, scale, random));
        trial.scene.spheres.back().hidden = random.chance(0.03);
    }
    return trial;
}

Trial lattice_trial(std::uint64_t seed) {
    Random random = random_of("lattice", seed);
    Trial trial{named("lattice", seed), {}, {random.whole(1, 16) * 2 - 1, random.whole(1, 16) * 2 - 1}};
    if (random.chance(0.2)) trial.size = {random.whole(1, 32), random.whole(1, 32)};
    const auto whole_vector = [&](int most) {
        const int x = random.whole(-most, most);
        const int y = random.whole(-most, most);
        return glm::dvec3(x, y, random.whole(-most, most));
    };
    Camera& camera = trial.scene.camera;
    const double m = trial.size.shorter_side();
    do {
        camera.eye = random.chance(0.5) ? glm::dvec3(0.0) : whole_vector(3);
        camera.center = camera.eye + (random.chance(0.6) ? glm::dvec3(0.0, 0.0, random.whole(1, 12)) : whole_vector(8));
        const double edge = random.chance(0.5) ? m : random.whole(1, 6);
        camera.right = {edge, 0.0, 0.0};
        camera.up = {0.0, edge, 0.0};
        if (random.chance(0.3)) std::swap(camera.right.x, camera.right.z);
    } while (camera_fault(camera));
    const int most = random.chance(0.5) ? 3 : 12;
    for (int count = random.whole(2, 30); count > 0; --count) {
        trial.scene.spheres.push_back({whole_vector(most), static_cast<double>(random.whole(1, most)), random_color(random)});
    }
    const double scale = random.chance(0.7) ? 1.0 : std::exp2(random.whole(-80, 80));
    for (glm::dvec3* v : {&camera.eye, &camera.center, &camera.right, &camera.up}) *v *= scale;
    for (Sphere& sphere : trial.scene.spheres) sphere = {sphere.center * scale, sphere.radius * scale, sphere.color};
    return trial;
}

Trial near_miss_trial(std::uint64_t seed) {
    Random random = random_of("near", seed);
    Trial trial{named("near misses", seed), {}, {random.whole(1, 24), random.whole(1, 24)}};
    const double scale = random.chance(0.6) ? 100.0 : random.of_size(1e-15, 1e15);
    Camera& camera = trial.scene.camera;
    if (!random.chance(0.3)) camera = random_camera(random, scale);
    for (int count = random.whole(4, 40); count > 0; --count) {
        Sphere sphere = random_sphere(camera, trial.size, scale, random);
        const glm::dvec3 ray = glm::normalize(ray_of(camera, trial.size, random));
        const glm::dvec3 c = sphere.center - camera.eye;
        glm::dvec3 meets = camera.eye;
        switch (random.whole(0, 3)) {
            case 0: meets += glm::dot(c, ray) * ray; break;                  // a tangent
            case 1: break;                                                   // the eye on the surface
            case 2: meets += scale * random.between(0.5, 2.0) * ray; break;  // through a point of a ray
            default:                                                         // where another sphere is seen
                if (!trial.scene.spheres.empty()) {
                    const Sphere& other = trial.scene.spheres[random.bits() % trial.scene.spheres.size()];
                    const glm::dvec3 o = other.center - camera.eye;
                    const double b = glm::dot(o, ray);
                    const double inside = other.radius * other.radius - glm::dot(o - b * ray, o - b * ray);
                    meets += (b - std::sqrt(std::max(inside, 0.0))) * ray;
                }
        }
        const double radius = beside(glm::distance(sphere.center, meets), random);
        if (radius > 0.0) sphere.radius = radius;
        if (random.chance(0.1) && !trial.scene.spheres.empty()) {
            sphere = trial.scene.spheres[random.bits() % trial.scene.spheres.size()];
            sphere.center.z = beside(sphere.center.z, random);
            sphere.radius = beside(sphere.radius, random);
        }
        trial.scene.spheres.push_back(sphere);
    }
    return trial;
}

Trial orthographic(Trial trial) {
    trial.name += ", orthographic";
    trial.scene.camera.projection = Projection::orthographic;
    return trial;
}

Trial parallel_near_miss_trial(std::uint64_t seed) {
    Random random = random_of("parallel", seed);
    Trial trial{named("parallel near misses", seed), {}, {random.whole(1, 24), random.whole(1, 24)}};
    const double scale = random.chance(0.6) ? 100.0 : random.of_size(1e-15, 1e15);
    Camera& camera = trial.scene.camera;
    if (!random.chance(0.3)) camera = random_camera(random, scale);
    const glm::dvec3 along = glm::normalize(camera.center - camera.eye);
    for (int count = random.whole(4, 40); count > 0; --count) {
        const RayCoefficients ray =
            ray_coefficients(trial.size, {random.whole(0, trial.size.width - 1), random.whole(0, trial.size.height - 1)});
        const double m = trial.size.shorter_side();
        const glm::dvec3 origin =
            camera.eye + static_cast<double>(ray.across) / m * camera.right + static_cast<double>(ray.upward) / m * camera.up;
        const double edge = glm::length(camera.right);
        const double radius = edge * random.of_size(0.01, 3.0);
        const glm::dvec3 beside = glm::normalize(glm::cross(along, unit_vector(random)));
        const double nearly = 1.0 + random.whole(-2, 2) * random.of_size(1e-17, 1e-4);
        Sphere sphere;
        sphere.radius = radius;
        switch (random.whole(0, 2)) {
            case 0: sphere.center = origin + edge * random.between(-1.0, 6.0) * along + nearly * radius * beside; break;
            case 1: sphere.center = origin + nearly * radius * unit_vector(random); break;
            default: sphere.center = origin + edge * random.between(-1.0, 6.0) * along; break;
        }
        sphere.color = random_color(random);
        trial.scene.spheres.push_back(sphere);
    }
    return orthographic(std::move(trial));
}

Trial bit_pattern_trial(std::uint64_t seed) {
    Random random = random_of("bits", seed);
    Trial trial{named("bit patterns", seed), {}, {random.whole(1, 5), random.whole(1, 5)}};
    const int middle = random.chance(0.3) ? random.whole(1, 2046) : 1023 + random.whole(-70, 70);
    const int spread = random.chance(0.3) ? 2046 : random.chance(0.5) ? 3 : 80;
    const auto any_number = [&] {
        if (random.chance(0.05)) return random.chance(0.5) ? 0.0 : -0.0;
        if (random.chance(0.02)) return std::bit_cast<double>(random.bits() >> 12);
        const int exponent = std::clamp(middle + random.whole(-spread, spread), 0, 2046);
        const int zeros = random.chance(0.5) ? random.whole(0, 51) : 0;
        const std::uint64_t fraction = (random.bits() >> 12 << zeros) & 0xfffffffffffffULL;
        const std::uint64_t sign = random.bits() >> 63 << 63;
        return std::bit_cast<double>(sign | static_cast<std::uint64_t>(exponent) << 52 | fraction);
    };
    const auto any_vector = [&] {
        const double x = any_number();
        const double y = any_number();
        return glm::dvec3(x, y, any_number());
    };
    Camera& camera = trial.scene.camera;
    do {
        camera.eye = random.chance(0.5) ? glm::dvec3(0.0) : any_vector();
        camera.center = any_vector();
        camera.right = camera.up = {};
        const double edge = any_number();
        const int axis = random.whole(0, 2);
        const int other = (axis + random.whole(1, 2)) % 3;
        camera.right[axis] = edge;
        camera.up[other] = random.chance(0.5) ? edge : -edge;
    } while (camera_fault(camera));
    for (int count = random.whole(1, 12); count > 0; --count) {
        Sphere sphere{any_vector(), std::fabs(any_number()), random_color(random)};
        if (sphere.radius == 0.0) continue;
        trial.scene.spheres.push_back(sphere);
        if (random.chance(0.3)) trial.scene.spheres.push_back({sphere.center, nudged(sphere.radius, 1), random_color(random)});
        if (!std::isfinite(trial.scene.spheres.back().radius)) trial.scene.spheres.pop_back();
    }
    return trial;
}

}  // namespace sphereview::oracle

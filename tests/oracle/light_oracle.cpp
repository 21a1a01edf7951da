#include "oracle/light_oracle.hpp"

#include <algorithm>

#include "oracle/oracle.hpp"
#include "oracle/whole_numbers.hpp"

namespace sphereview::oracle {

namespace {

// x + y sqrt(d), in whole numbers; d is the same for all that are added or multiplied.
struct Surd {
    Unlimited x;
    Unlimited y;

    int sign(const Unlimited& d) const {
        const int of_x = x.sign();
        const int of_y = d == 0 ? 0 : y.sign();
        if (of_x * of_y >= 0) return of_x != 0 ? of_x : of_y;
        return x * x > y * y * d ? of_x : x * x < y * y * d ? of_y : 0;
    }
};

Surd operator+(const Surd& a, const Surd& b) { return {a.x + b.x, a.y + b.y}; }
Surd operator*(const Unlimited& factor, const Surd& a) { return {factor * a.x, factor * a.y}; }
Surd operator-(const Surd& a, const Surd& b) { return {a.x - b.x, a.y - b.y}; }
Surd product(const Surd& a, const Surd& b, const Unlimited& d) { return {a.x * b.x + a.y * b.y * d, a.x * b.y + a.y * b.x}; }

using Whole = WholeVector<Unlimited>;

}  // namespace

std::vector<bool> shines(const Scene& scene, PictureSize size, Pixel pixel, std::int32_t number,
                         std::span<const glm::dvec3> directions, const LightRules& rules) {
    const Camera& camera = scene.camera;
    const Sphere& seen = scene.spheres[static_cast<std::size_t>(number)];
    Grid ray_grid;
    for (const glm::dvec3& v : {camera.eye, camera.center, camera.right, camera.up}) ray_grid.include(v);
    Grid grid;
    grid.include(camera.eye);
    if (camera.orthographic()) {
        grid.include(camera.right);
        grid.include(camera.up);
    }
    for (const Sphere& sphere : scene.spheres) {
        grid.include(sphere.center);
        grid.include(sphere.radius);
    }

    // The ray, m times as long, and the place t = (b +- sqrt(d)) / A where it hits.
    const Unlimited m = std::min(size.width, size.height);
    const Unlimited across = 2 * pixel.x + 1 - size.width;
    const Unlimited upward = size.height - 1 - 2 * pixel.y;
    const Whole forward = Whole(ray_grid, camera.center) - Whole(ray_grid, camera.eye);
    const Whole right(ray_grid, camera.right);
    const Whole up(ray_grid, camera.up);
    const auto at_pixel = [&](const Whole& v, const Whole& r, const Whole& u) {
        return Whole{m * v.x + across * r.x + upward * u.x, m * v.y + across * r.y + upward * u.y,
                     m * v.z + across * r.z + upward * u.z};
    };
    const bool parallel = camera.orthographic();
    const Whole ray = parallel ? forward : at_pixel(forward, right, up);
    // Where the ray begins; orthographic: m times as far, as are all places and sizes.
    const Whole eye(grid, camera.eye);
    const Whole origin = parallel ? at_pixel(eye, Whole(grid, camera.right), Whole(grid, camera.up)) : eye;
    const Unlimited larger = parallel ? m : 1;
    const auto place = [&](const glm::dvec3& point) {
        const Whole whole(grid, point);
        return Whole{larger * whole.x, larger * whole.y, larger * whole.z};
    };
    const Whole to_center = place(seen.center) - origin;
    const Unlimited radius = larger * grid.steps<Unlimited>(seen.radius);
    const Unlimited a = dot(ray, ray);
    const Unlimited b = dot(to_center, ray);
    const Unlimited d = b * b - a * (dot(to_center, to_center) - radius * radius);
    const bool outside = dot(to_center, to_center) - radius * radius > 0;
    const Surd t{b, outside ? -1 : 1};  // times A

    // From a point to where the ray hits, times A.
    const auto from = [&](const glm::dvec3& point) {
        const Whole offset = origin - place(point);
        return std::array<Surd, 3>{Surd{a * offset.x, 0} + ray.x * t, Surd{a * offset.y, 0} + ray.y * t,
                                   Surd{a * offset.z, 0} + ray.z * t};
    };
    const auto along = [](const std::array<Surd, 3>& v, const Whole& w) { return w.x * v[0] + w.y * v[1] + w.z * v[2]; };
    const std::array<Surd, 3> normal = from(seen.center);

    // The spheres in whose way the light may be, as quadratics of the line to it but for its direction.
    struct Other {
        std::array<Surd, 3> offset;
        Surd c;
    };
    std::vector<Other> others;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const Sphere& sphere = scene.spheres[i];
        if (static_cast<std::int32_t>(i) == number || (sphere.hidden && !rules.hidden_blocks)) continue;
        // One that is the seen sphere once more is that sphere.
        if (same_geometry(sphere, seen) || (sphere.center == seen.center && sphere.radius == seen.radius)) continue;
        if (!eye_is_outside(sphere, camera) && !rules.spheres_of_eye_block) continue;
        Other other{from(sphere.center), {0, 0}};
        for (const Surd& component : other.offset) other.c = other.c + product(component, component, d);
        const Unlimited scaled = a * larger * grid.steps<Unlimited>(sphere.radius);
        other.c = other.c - Surd{scaled * scaled, 0};
        others.push_back(other);
    }

    std::vector<bool> result;
    for (const glm::dvec3& direction : directions) {
        Grid direction_grid;
        direction_grid.include(direction);
        const Whole l(direction_grid, direction);
        const Unlimited square = dot(l, l);
        const int facing = along(normal, l).sign(d) * (outside || !rules.normal_turned_to_eye ? 1 : -1);
        const bool faces = rules.edge_is_dark ? facing > 0 : facing >= 0;
        // |offset + u L| = r has a root u > 0: the quadratic square u^2 + 2 h u + c.
        const bool blocked = faces && std::ranges::any_of(others, [&](const Other& other) {
                                 const Surd h = along(other.offset, l);
                                 const int discriminant = (product(h, h, d) - square * other.c).sign(d);
                                 if (discriminant < 0 || (discriminant == 0 && !rules.tangent_blocks)) return false;
                                 return !rules.only_towards_the_light || other.c.sign(d) < 0 || h.sign(d) < 0;
                             });
        result.push_back(faces && !blocked);
    }
    return result;
}

}  // namespace sphereview::oracle

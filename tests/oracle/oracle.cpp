#include "oracle/oracle.hpp"

#include <optional>

#include "base/parallel.hpp"
#include "oracle/roots.hpp"
#include "oracle/whole_numbers.hpp"

namespace sphereview::oracle {

namespace {

// Rays and spheres on grids of their own: the scale of the rays scales every t alike, that of the spheres too.
struct Grids {
    Grid ray;
    Grid sphere;

    explicit Grids(const Camera& camera) {
        ray.include(camera.eye);
        ray.include(camera.center);
        ray.include(camera.right);
        ray.include(camera.up);
        sphere.include(camera.eye);
        if (!camera.orthographic()) return;
        sphere.include(camera.right);
        sphere.include(camera.up);
    }
    void include(const Sphere& added) {
        sphere.include(added.center);
        sphere.include(added.radius);
    }
    // No integer in root_against() and compare_roots() is longer.
    int bits(const Camera& camera, PictureSize size) const {
        const int of_pixel = static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(size.width, size.height)))) + 4;
        const int of_ray = ray.bits() + of_pixel;
        const int of_sphere = sphere.bits() + (camera.orthographic() ? of_pixel : 2);
        return std::max(2 * of_ray + 4 * of_sphere, 4 * of_ray + 2 * of_sphere) + 20;
    }
};

template <typename Integer>
struct Hit {
    Quadratic<Integer> quadratic;
    Which root;
};

// P = eye + t D with D = (center - eye) + (2i + 1 - W) / m right + (H - 1 - 2j) / m up; in whole numbers m D. Orthographic:
// P = O + t D with D = center - eye and O = eye + (2i + 1 - W) / m right + (H - 1 - 2j) / m up; in whole numbers m O, and spheres
// that are m times as large.
template <typename Integer>
class Tracer {
public:
    Tracer(const Scene& scene, PictureSize size, const Grids& grids, const Rules& rules)
        : size_(size),
          rules_(rules),
          parallel_(scene.camera.orthographic()),
          forward_(WholeVector<Integer>(grids.ray, scene.camera.center) - WholeVector<Integer>(grids.ray, scene.camera.eye)),
          right_(grids.ray, scene.camera.right),
          up_(grids.ray, scene.camera.up) {
        const Integer m = std::min(size.width, size.height);
        if (parallel_) {
            add_parallels(scene, grids, m);
            return;
        }
        forward_ = {forward_.x * m, forward_.y * m, forward_.z * m};
        const WholeVector<Integer> eye(grids.sphere, scene.camera.eye);
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
            const Sphere& sphere = scene.spheres[i];
            if (sphere.hidden) continue;
            const WholeVector<Integer> center = WholeVector<Integer>(grids.sphere, sphere.center) - eye;
            const auto radius = grids.sphere.steps<Integer>(sphere.radius);
            spheres_.push_back({static_cast<std::int32_t>(i), dot(center, forward_), dot(center, right_), dot(center, up_),
                                dot(center, center) - radius * radius});
        }
    }

    std::int32_t visible(Pixel pixel) const {
        const Integer across = 2 * pixel.x + 1 - size_.width;
        const Integer upward = size_.height - 1 - 2 * pixel.y;
        const WholeVector<Integer> d = direction(across, upward);
        const Integer a = dot(d, d);
        if (a == 0) return -1;
        std::int32_t nearest_number = -1;
        std::optional<Hit<Integer>> nearest;
        for (const Terms& terms : spheres_) {
            const Quadratic<Integer> quadratic = quadratic_of(terms, across, upward);
            std::optional<Which> root = root_seen(a, quadratic);
            if (root && rules_.side_of_eye) root = terms.c > 0 ? Which::smaller : Which::larger;
            if (!root) continue;
            if (nearest) {
                const int order = compare_roots(a, quadratic, *root, nearest->quadratic, nearest->root);
                if (order > 0 || (order == 0 && rules_.first_of_equals)) continue;
            }
            nearest = Hit<Integer>{quadratic, *root};
            nearest_number = terms.number;
        }
        return nearest_number;
    }

    int discriminant_sign(Pixel pixel) const {
        const Integer across = 2 * pixel.x + 1 - size_.width;
        const Integer upward = size_.height - 1 - 2 * pixel.y;
        const WholeVector<Integer> d = direction(across, upward);
        return discriminant(dot(d, d), quadratic_of(spheres_.front(), across, upward)).sign();
    }

private:
    // b is linear in the pixel: forward + across right + upward up.
    struct Terms {
        std::int32_t number;
        Integer forward;
        Integer right;
        Integer up;
        Integer c;
        // Orthographic:
        WholeVector<Integer> center{0, 0, 0};  // from the eye, times m
        Integer radius_square = 0;             // times m m
    };

    void add_parallels(const Scene& scene, const Grids& grids, const Integer& m) {
        const WholeVector<Integer> eye(grids.sphere, scene.camera.eye);
        right_ = WholeVector<Integer>(grids.sphere, scene.camera.right);
        up_ = WholeVector<Integer>(grids.sphere, scene.camera.up);
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
            const Sphere& sphere = scene.spheres[i];
            if (sphere.hidden) continue;
            const WholeVector<Integer> center = WholeVector<Integer>(grids.sphere, sphere.center) - eye;
            const Integer radius = m * grids.sphere.steps<Integer>(sphere.radius);
            Terms terms{static_cast<std::int32_t>(i), {}, {}, {}, {}, {m * center.x, m * center.y, m * center.z}, radius * radius};
            terms.c = dot(terms.center, terms.center) - terms.radius_square;
            spheres_.push_back(terms);
        }
    }

    WholeVector<Integer> direction(const Integer& across, const Integer& upward) const {
        if (parallel_) return forward_;
        return {forward_.x + across * right_.x + upward * up_.x, forward_.y + across * right_.y + upward * up_.y,
                forward_.z + across * right_.z + upward * up_.z};
    }

    Quadratic<Integer> quadratic_of(const Terms& terms, const Integer& across, const Integer& upward) const {
        if (!parallel_) return {terms.forward + across * terms.right + upward * terms.up, terms.c};
        if (!rules_.origins_in_plane) return {dot(terms.center, forward_), terms.c};
        const WholeVector<Integer> center{terms.center.x - across * right_.x - upward * up_.x,
                                          terms.center.y - across * right_.y - upward * up_.y,
                                          terms.center.z - across * right_.z - upward * up_.z};
        return {dot(center, forward_), dot(center, center) - terms.radius_square};
    }

    static Integer discriminant(const Integer& a, const Quadratic<Integer>& p) { return p.b * p.b - a * p.c; }

    // Which root is the hit, if any: the smallest positive one.
    std::optional<Which> root_seen(const Integer& a, const Quadratic<Integer>& p) const {
        const int sign = discriminant(a, p).sign();
        if (sign < 0 || (sign == 0 && !rules_.tangent_hits)) return std::nullopt;
        const int least = rules_.zero_is_positive ? 0 : 1;
        const Integer zero = 0;
        const Integer one = 1;
        if (root_against(a, p, Which::larger, zero, one) < least) return std::nullopt;
        if (rules_.near_root_from_inside || root_against(a, p, Which::smaller, zero, one) >= least) return Which::smaller;
        return Which::larger;
    }

    PictureSize size_;
    Rules rules_;
    bool parallel_;
    WholeVector<Integer> forward_;
    WholeVector<Integer> right_;
    WholeVector<Integer> up_;
    std::vector<Terms> spheres_;
};

Grids grids_of(const Scene& scene) {
    Grids grids(scene.camera);
    for (const Sphere& sphere : scene.spheres) grids.include(sphere);
    return grids;
}

template <typename Integer>
std::vector<std::int32_t> traced(const Tracer<Integer>& tracer, const std::vector<Pixel>& pixels) {
    std::vector<std::int32_t> numbers(pixels.size());
    parallel_pieces(numbers.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) numbers[i] = tracer.visible(pixels[i]);
    });
    return numbers;
}

}  // namespace

std::vector<std::int32_t> pixels(const Scene& scene, PictureSize size, const std::vector<Pixel>& some, const Rules& rules) {
    const Grids grids = grids_of(scene);
    if (grids.bits(scene.camera, size) <= limited_bits) return traced(Tracer<Limited>(scene, size, grids, rules), some);
    return traced(Tracer<Unlimited>(scene, size, grids, rules), some);
}

std::vector<std::int32_t> picture(const Scene& scene, PictureSize size, const Rules& rules) {
    std::vector<Pixel> all;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) all.push_back({x, y});
    }
    return pixels(scene, size, all, rules);
}

std::int32_t pixel(const Scene& scene, PictureSize size, Pixel one) { return pixels(scene, size, {one}).front(); }

int eye_side(const Sphere& sphere, const glm::dvec3& eye) {
    Grid grid;
    grid.include(eye);
    grid.include(sphere.center);
    grid.include(sphere.radius);
    const WholeVector<Unlimited> center = WholeVector<Unlimited>(grid, sphere.center) - WholeVector<Unlimited>(grid, eye);
    const auto radius = grid.steps<Unlimited>(sphere.radius);
    return Unlimited(dot(center, center) - radius * radius).sign();
}

bool eye_is_outside(const Sphere& sphere, const Camera& camera) {
    if (!camera.orthographic()) return eye_side(sphere, camera.eye) > 0;
    // The plane's nearest point is where its normal from the centre ends: |C.N| / |N| away.
    Grid grid;
    Grid edges;
    grid.include(camera.eye);
    grid.include(sphere.center);
    grid.include(sphere.radius);
    edges.include(camera.right);
    edges.include(camera.up);
    const WholeVector<Unlimited> r(edges, camera.right);
    const WholeVector<Unlimited> u(edges, camera.up);
    const WholeVector<Unlimited> n{r.y * u.z - r.z * u.y, r.z * u.x - r.x * u.z, r.x * u.y - r.y * u.x};
    const Unlimited depth = dot(WholeVector<Unlimited>(grid, sphere.center) - WholeVector<Unlimited>(grid, camera.eye), n);
    const auto radius = grid.steps<Unlimited>(sphere.radius);
    return depth * depth - radius * radius * dot(n, n) > 0;
}

int discriminant_sign(const Camera& camera, PictureSize size, Pixel pixel, const Sphere& sphere) {
    Scene scene;
    scene.camera = camera;
    scene.spheres = {sphere};
    scene.spheres.front().hidden = false;
    return Tracer<Unlimited>(scene, size, grids_of(scene), {}).discriminant_sign(pixel);
}

}  // namespace sphereview::oracle

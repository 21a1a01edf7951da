#include "exact/drawn.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "exact/exact_decision.hpp"

namespace sphereview {

namespace {

// Sizes |x| + |y| + |z| + r, after scaling, for which neither squares overflow nor the bound underflows in float.
constexpr int smallest_exponent = -30;
constexpr int largest_exponent = 60;
constexpr double smallest_radius = 0x1p-100;  // anything smaller differs from it by less than any bound

// Finds spheres with the same centre and radius. Open addressing over indices: a million spheres, no allocation each.
class SeenSpheres {
public:
    explicit SeenSpheres(const std::vector<Sphere>& spheres)
        : spheres_(spheres), slots_(std::bit_ceil(spheres.size() * 2 + 2), empty) {}

    // Whether an equal sphere was added before; adds it if not.
    bool contains_or_add(std::size_t index) {
        const Sphere& sphere = spheres_[index];
        for (std::size_t slot = hash(sphere);; ++slot) {
            std::int32_t& place = slots_[slot & (slots_.size() - 1)];
            if (place == empty) {
                place = static_cast<std::int32_t>(index);
                return false;
            }
            const Sphere& other = spheres_[static_cast<std::size_t>(place)];
            if (other.center == sphere.center && other.radius == sphere.radius) return true;
        }
    }

private:
    static constexpr std::int32_t empty = -1;

    static std::size_t hash(const Sphere& sphere) {
        std::uint64_t hash = 0;
        for (const double value : {sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius}) {
            // Adding 0 makes -0 and 0 alike. The multiplier is that of Knuth's MMIX generator.
            hash = (hash ^ std::bit_cast<std::uint64_t>(value + 0.0)) * 6364136223846793005ULL;
            hash ^= hash >> 32;
        }
        return static_cast<std::size_t>(hash);
    }

    const std::vector<Sphere>& spheres_;
    std::vector<std::int32_t> slots_;
};

// What is relative to the eye, times 2^-exponent: a difference of two doubles may overflow.
struct Relative {
    glm::dvec3 center;
    int exponent = 0;

    Relative(const Sphere& sphere, const glm::dvec3& eye) : center(sphere.center - eye) {
        if (std::isfinite(center.x) && std::isfinite(center.y) && std::isfinite(center.z)) return;
        // Numbers so large lose nothing by halving; others beside them do not matter.
        center = sphere.center * 0.5 - eye * 0.5;
        exponent = 1;
    }
};

// The exponent of the largest of a sphere's numbers, relative to the eye.
int size_exponent(const Sphere& sphere, const glm::dvec3& eye) {
    const Relative relative(sphere, eye);
    const glm::dvec3& c = relative.center;
    const double radius = std::ldexp(sphere.radius, -relative.exponent);
    int exponent = 0;
    std::frexp(std::max({std::fabs(c.x), std::fabs(c.y), std::fabs(c.z), radius}), &exponent);
    return exponent + relative.exponent;
}

glm::vec4 relative_to_eye(const Sphere& sphere, const glm::dvec3& eye, int scale) {
    constexpr double limit = 0x1p60;
    const Relative relative(sphere, eye);
    const glm::dvec3& c = relative.center;
    const auto component = [&](double value) {
        return static_cast<float>(std::clamp(std::ldexp(value, scale + relative.exponent), -limit, limit));
    };
    const auto radius = static_cast<float>(std::clamp(std::ldexp(sphere.radius, scale), smallest_radius, limit));
    const EyeSide side = eye_side(sphere, eye);
    const float signed_radius = side == EyeSide::outside ? radius : side == EyeSide::inside ? -radius : 0.0F;
    return {component(c.x), component(c.y), component(c.z), signed_radius};
}

}  // namespace

DrawnSpheres drawn_spheres(const Scene& scene) {
    DrawnSpheres drawn;
    const glm::dvec3& eye = scene.camera.eye;
    std::vector<std::int32_t> numbers;
    numbers.reserve(scene.spheres.size());
    SeenSpheres seen(scene.spheres);
    int largest = std::numeric_limits<int>::min();
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        if (scene.spheres[i].hidden || seen.contains_or_add(i)) continue;
        numbers.push_back(static_cast<std::int32_t>(i));
        largest = std::max(largest, size_exponent(scene.spheres[i], eye));
    }
    if (numbers.empty()) return drawn;

    // A power of two changes nothing but the range: only where the largest sphere needs it.
    constexpr int comfortable = 30;
    if (largest < 0 || largest > largest_exponent - 3) drawn.scale = comfortable - largest;
    drawn.center_radius.reserve(numbers.size());
    for (const std::int32_t number : numbers) {
        const Sphere& sphere = scene.spheres[static_cast<std::size_t>(number)];
        drawn.center_radius.push_back(relative_to_eye(sphere, eye, drawn.scale));
        const int exponent = size_exponent(sphere, eye) + drawn.scale;
        drawn.beyond_float = drawn.beyond_float || exponent < smallest_exponent || exponent > largest_exponent - 3;
    }
    if (numbers.size() != scene.spheres.size()) drawn.numbers = std::move(numbers);
    return drawn;
}

FloatView float_view(const DrawnSpheres& drawn, const Camera& camera, PictureSize size, double unit) {
    FloatView view{ray_frame<float>(camera, size), 0.0F, false};
    const double kappa = ray_condition(camera);
    view.error_scale = static_cast<float>(error_scale(std::min(kappa, largest_float_condition), unit));
    view.all_doubtful = drawn.beyond_float || !view.rays.in_range || !(kappa <= largest_float_condition);
    return view;
}

}  // namespace sphereview

#include "exact/drawn.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <memory>
#include <mutex>

#include "base/parallel.hpp"
#include "exact/exact_decision.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr std::size_t drawn_at_once = 4096;

// Sizes, after scaling, for which neither squares overflow nor the bound underflows in float.
constexpr double smallest_size = 0x1p-31;
constexpr double largest_size = 0x1p57;
constexpr int middle_exponent = 13;
constexpr double smallest_radius = 0x1p-100;  // a smaller radius differs from this one by less than any bound

// The largest of a sphere's numbers, relative to the eye; infinite when a difference overflows.
double size_of(const Sphere& sphere, const glm::dvec3& eye) { return std::max(largest_of(sphere.center - eye), sphere.radius); }

bool in_range(double size) { return size >= smallest_size && size < largest_size; }

// A set of spheres by centre and radius: open addressing over their numbers, no allocation each. Threads may add at once;
// which ones are marked does not depend on their order.
class FirstSpheres {
public:
    FirstSpheres(const std::vector<Sphere>& spheres, std::vector<std::uint8_t>& marks)
        : spheres_(spheres),
          marks_(marks),
          mask_(std::bit_ceil(spheres.size() * 2 + 2) - 1),
          slots_(std::make_unique<std::atomic<std::uint64_t>[]>(mask_ + 1)) {}

    // Equal spheres have equal hashes. Asks for the place where it is looked for first to be in the processor's cache soon.
    std::uint64_t hash(std::size_t index) const {
        const Sphere& sphere = spheres_[index];
        std::uint64_t hash = 0;
        for (const double value : {sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius}) {
            // Adding 0 makes -0 and 0 alike. The multiplier is that of Knuth's MMIX generator.
            hash = (hash ^ std::bit_cast<std::uint64_t>(value + 0.0)) * 6364136223846793005ULL;
            hash ^= hash >> 32;
        }
#ifdef __GNUC__
        __builtin_prefetch(&slots_[hash & mask_], 1);
#endif
        return hash;
    }

    // Marks the sphere or, if that has a greater number, the equal one that is there already.
    void add(std::size_t index, std::uint64_t hash) {
        // A slot holds the number, from 1 on, and above it some of the hash, so that few others have to be looked at.
        const std::uint64_t tag = hash >> 32 << 32;
        const std::uint64_t entry = tag | (index + 1);
        for (std::size_t slot = hash & mask_;; slot = (slot + 1) & mask_) {
            std::uint64_t other = 0;
            if (slots_[slot].compare_exchange_strong(other, entry, std::memory_order_relaxed)) return;
            if ((other ^ tag) >> 32 != 0 || !equal(index, number(other))) continue;
            while (entry < other && !slots_[slot].compare_exchange_weak(other, entry, std::memory_order_relaxed)) {
            }
            marks_[number(std::max(entry, other))] = 1;
            return;
        }
    }

private:
    static std::size_t number(std::uint64_t entry) { return (entry & 0xffffffffU) - 1; }

    bool equal(std::size_t a, std::size_t b) const {
        return spheres_[a].center == spheres_[b].center && spheres_[a].radius == spheres_[b].radius;
    }

    const std::vector<Sphere>& spheres_;
    std::vector<std::uint8_t>& marks_;
    std::size_t mask_;
    std::unique_ptr<std::atomic<std::uint64_t>[]> slots_;
};

// For each sphere 1 if it can never be seen: it is hidden, or an earlier one that is not has the same centre and radius
// (-0 equals 0, colours do not matter), and of equal hits the first is seen. With all cores.
std::vector<std::uint8_t> never_seen(const std::vector<Sphere>& spheres) {
    std::vector<std::uint8_t> marks(spheres.size());
    FirstSpheres first(spheres, marks);
    parallel_pieces(spheres.size(), drawn_at_once, [&](std::size_t begin, std::size_t end) {
        std::array<std::uint64_t, 32> hashes{};
        for (std::size_t i = begin; i < end; i += hashes.size()) {
            const std::size_t count = std::min(hashes.size(), end - i);
            for (std::size_t k = 0; k < count; ++k) hashes[k] = first.hash(i + k);
            for (std::size_t k = 0; k < count; ++k) {
                if (spheres[i + k].hidden) {
                    marks[i + k] = 1;
                } else {
                    first.add(i + k, hashes[k]);
                }
            }
        }
    });
    return marks;
}

struct Numbers {
    std::vector<std::int32_t> drawn;  // empty when `all`
    std::vector<std::int32_t> twins;
    bool all = false;
};

// The numbers of the spheres that may be seen, and of the spheres that equal one of them.
Numbers numbers_of(const std::vector<Sphere>& spheres) {
    const std::vector<std::uint8_t> unseen = never_seen(spheres);
    Numbers numbers;
    const auto left_out = static_cast<std::size_t>(std::ranges::count(unseen, 1));
    numbers.all = left_out == 0;
    if (numbers.all) return numbers;
    numbers.drawn.reserve(spheres.size() - left_out);
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        if (unseen[i] == 0) {
            numbers.drawn.push_back(static_cast<std::int32_t>(i));
        } else if (!spheres[i].hidden) {
            numbers.twins.push_back(static_cast<std::int32_t>(i));
        }
    }
    return numbers;
}

// The scale, other than 0 only where most spheres need it: a power of two changes nothing but the range.
// `numbers` as for drawn_of().
int scale_for(const Scene& scene, const glm::dvec3& eye, const std::vector<std::int32_t>& numbers) {
    const std::size_t all = numbers.empty() ? scene.spheres.size() : numbers.size();
    std::atomic<std::size_t> out_of_range = 0;
    const auto size_at = [&](std::size_t i) {
        return size_of(scene.spheres[numbers.empty() ? i : static_cast<std::size_t>(numbers[i])], eye);
    };
    parallel_pieces(all, drawn_at_once, [&](std::size_t begin, std::size_t end) {
        std::size_t count = 0;
        for (std::size_t i = begin; i < end; ++i) count += in_range(size_at(i)) ? 0 : 1;
        out_of_range += count;
    });
    if (out_of_range * 2 <= all) return 0;
    std::vector<int> exponents(all);
    for (std::size_t i = 0; i < all; ++i) exponents[i] = exponent_of(std::min(size_at(i), 0x1p1023));
    const auto median = exponents.begin() + static_cast<std::ptrdiff_t>(exponents.size() / 2);
    std::nth_element(exponents.begin(), median, exponents.end());
    return middle_exponent - *median;
}

// Multiplies by 2^scale. In two steps, each a power that a double holds; no product in between is out of range if the last is not.
class Scaling {
public:
    explicit Scaling(int scale) : first_(std::ldexp(1.0, scale / 2)), second_(std::ldexp(1.0, scale - scale / 2)) {}
    double operator()(double value) const { return value * first_ * second_; }

private:
    double first_;
    double second_;
};

float signed_radius(double radius, EyeSide side) {
    const auto size = static_cast<float>(std::max(radius, smallest_radius));
    return side == EyeSide::outside ? size : side == EyeSide::on_surface ? 0.0F : -size;
}

// The sphere in the form of DrawnSpheres::center_radius; none for a sphere that is beyond float.
std::optional<glm::vec4> in_float(const Sphere& sphere, EyeSide side, const glm::dvec3& eye, const Scaling& scaled) {
    if (!in_range(scaled(size_of(sphere, eye)))) return std::nullopt;
    const glm::dvec3 c = sphere.center - eye;
    return glm::vec4(static_cast<float>(scaled(c.x)), static_cast<float>(scaled(c.y)), static_cast<float>(scaled(c.z)),
                     signed_radius(scaled(sphere.radius), side));
}

// `numbers`: of those that are drawn; empty when all are.
DrawnSpheres drawn_of(const Scene& scene, const Camera& camera, std::vector<std::int32_t> numbers) {
    DrawnSpheres drawn;
    drawn.numbers = std::move(numbers);
    const glm::dvec3& eye = camera.eye;
    const EyeSides sides(camera);
    drawn.orthographic = camera.orthographic();
    const std::size_t count = drawn.numbers.empty() ? scene.spheres.size() : drawn.numbers.size();
    drawn.scale = scale_for(scene, eye, drawn.numbers);
    const Scaling scaled(drawn.scale);
    drawn.center_radius.reserve(count + DrawnSpheres::room_for_late);
    drawn.center_radius.resize(count);
    std::mutex beyond_float;
    parallel_pieces(count, drawn_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Sphere& sphere = scene.spheres[static_cast<std::size_t>(drawn.number(i))];
            const EyeSide side = sides(sphere);
            if (const auto values = in_float(sphere, side, eye, scaled)) {
                drawn.center_radius[i] = *values;
            } else {  // leaves the mark, zeros
                const std::lock_guard lock(beyond_float);
                drawn.beyond_float[static_cast<std::uint32_t>(i)] = side;
            }
        }
    });
    return drawn;
}

DrawnSpheres nothing_drawn(const Camera& camera) {
    DrawnSpheres nothing;
    nothing.orthographic = camera.orthographic();
    return nothing;
}

}  // namespace

DrawnSpheres drawn_spheres(const Scene& scene) { return drawn_spheres(scene, scene.camera); }

DrawnSpheres drawn_spheres(const Scene& scene, const Camera& camera) {
    Numbers numbers = numbers_of(scene.spheres);
    if (numbers.all ? scene.spheres.empty() : numbers.drawn.empty()) return nothing_drawn(camera);
    DrawnSpheres drawn = drawn_of(scene, camera, std::move(numbers.drawn));
    drawn.twins = std::move(numbers.twins);
    return drawn;
}

DrawnSpheres drawn_again(const Scene& scene, const Camera& camera, const DrawnSpheres& drawn) {
    assert(drawn.gone.empty() && drawn.late == 0);
    if (drawn.size() == 0) return nothing_drawn(camera);
    DrawnSpheres again = drawn_of(scene, camera, drawn.numbers);
    again.twins = drawn.twins;
    return again;
}

std::optional<glm::vec4> drawn_form(const Sphere& sphere, const Camera& camera, int scale) {
    return in_float(sphere, EyeSides(camera)(sphere), camera.eye, Scaling(scale));
}

bool same_eye(const Camera& a, const Camera& b) {
    if (a.eye != b.eye || a.projection != b.projection) return false;
    return !a.orthographic() || (a.right == b.right && a.up == b.up);
}

std::optional<std::size_t> DrawnSpheres::index_of(std::uint32_t number) const {
    const auto wanted = static_cast<std::int32_t>(number);
    const auto is_gone = [&](std::size_t index) { return std::ranges::binary_search(gone, static_cast<std::uint32_t>(index)); };
    if (numbers.empty()) return number < size() && !is_gone(number) ? std::optional<std::size_t>(number) : std::nullopt;
    const auto in_order = numbers.end() - static_cast<std::ptrdiff_t>(late);
    // Of several indices with the same number all but the last are gaps.
    const auto found = std::upper_bound(numbers.begin(), in_order, wanted);
    if (found != numbers.begin() && *(found - 1) == wanted) {
        const auto index = static_cast<std::size_t>(found - 1 - numbers.begin());
        if (!is_gone(index)) return index;
    }
    for (auto later = in_order; later != numbers.end(); ++later) {
        const auto index = static_cast<std::size_t>(later - numbers.begin());
        if (*later == wanted && !is_gone(index)) return index;
    }
    return std::nullopt;
}

EyeSide DrawnSpheres::side(std::size_t index) const {
    const glm::vec4& sphere = center_radius[index];
    if (sphere.w > 0.0F) return EyeSide::outside;
    if (sphere.w < 0.0F) return orthographic ? EyeSide::in_plane : EyeSide::inside;
    const auto beyond = beyond_float.find(static_cast<std::uint32_t>(index));
    return beyond == beyond_float.end() ? EyeSide::on_surface : beyond->second;
}

FloatView float_view(const Camera& camera, PictureSize size, int scale, double unit) {
    FloatView view{ray_basis<float>(camera, size, scale), 0.0F, false};
    const double kappa = ray_condition(camera);
    view.error_scale = static_cast<float>(error_scale(std::min(filter_condition(camera), largest_float_condition), unit));
    view.all_doubtful = !view.rays.in_range || !(kappa <= largest_float_condition);
    return view;
}

}  // namespace sphereview

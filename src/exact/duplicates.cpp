#include "exact/duplicates.hpp"

#include <atomic>
#include <bit>
#include <cstddef>
#include <memory>

#include "base/parallel.hpp"

namespace sphereview {

namespace {

// A set of spheres by centre and radius: open addressing over their numbers, no allocation each. Threads may add at once;
// which ones are marked does not depend on their order.
class FirstSpheres {
public:
    FirstSpheres(const std::vector<Sphere>& spheres, std::vector<std::uint8_t>& marks)
        : spheres_(spheres),
          marks_(marks),
          mask_(std::bit_ceil(spheres.size() * 2 + 2) - 1),
          slots_(std::make_unique<std::atomic<std::uint32_t>[]>(mask_ + 1)) {}

    // Marks the sphere or, if that has a greater number, the equal one that is there already.
    void add(std::size_t index) {
        const Sphere& sphere = spheres_[index];
        const auto entry = static_cast<std::uint32_t>(index) + 1;  // 0 is an empty slot
        for (std::size_t slot = hash(sphere);; ++slot) {
            std::atomic<std::uint32_t>& place = slots_[slot & mask_];
            std::uint32_t other = 0;
            if (place.compare_exchange_strong(other, entry, std::memory_order_relaxed)) return;
            const Sphere& there = spheres_[other - 1];
            if (!(there.center == sphere.center && there.radius == sphere.radius)) continue;
            while (entry < other && !place.compare_exchange_weak(other, entry, std::memory_order_relaxed)) {
            }
            marks_[(entry < other ? other : entry) - 1] = 1;
            return;
        }
    }

private:
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
    std::vector<std::uint8_t>& marks_;
    std::size_t mask_;
    std::unique_ptr<std::atomic<std::uint32_t>[]> slots_;
};

}  // namespace

std::vector<std::uint8_t> never_seen(const std::vector<Sphere>& spheres) {
    std::vector<std::uint8_t> marks(spheres.size());
    FirstSpheres first(spheres, marks);
    constexpr std::size_t spheres_at_once = 4096;
    parallel_pieces(spheres.size(), spheres_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (spheres[i].hidden) {
                marks[i] = 1;
            } else {
                first.add(i);
            }
        }
    });
    return marks;
}

}  // namespace sphereview

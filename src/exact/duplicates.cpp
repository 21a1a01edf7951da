#include "exact/duplicates.hpp"

#include <algorithm>
#include <array>
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

}  // namespace

std::vector<std::uint8_t> never_seen(const std::vector<Sphere>& spheres) {
    std::vector<std::uint8_t> marks(spheres.size());
    FirstSpheres first(spheres, marks);
    constexpr std::size_t spheres_at_once = 4096;
    parallel_pieces(spheres.size(), spheres_at_once, [&](std::size_t begin, std::size_t end) {
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

}  // namespace sphereview

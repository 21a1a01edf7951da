// What float left doubtful in a buffer of visible spheres, decided as for an export, a little at a time.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>

#include "exact/resolve.hpp"

namespace sphereview {

// A time to stop at.
class Deadline {
public:
    explicit Deadline(double seconds)  // from now
        : end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))) {}
    bool passed() const { return Clock::now() > end_; }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point end_;
};

struct Decided {
    bool any = false;
    bool all = true;
};

// Replaces doubtful numbers in `visible`, indices among the drawn spheres, by certain ones: at least some, then as many as there is
// time for. pixel_of(i) is the resolver's pixel of visible[i].
Decided decide_doubtful(const Resolver& resolver, const DrawnSpheres& drawn, std::span<std::int32_t> visible,
                        const std::function<Pixel(int place)>& pixel_of, const Deadline& deadline);

}  // namespace sphereview

// The times of one picture's phases.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string_view>

namespace sphereview {

// lists: the spheres that each tile can show. resolve: deciding what float could not, and colouring. light: where lights shine.
enum class Phase { read, context, shaders, lists, prepare, trace, read_back, resolve, light, encode, write };

inline constexpr std::array<std::string_view, 11> phase_names = {"read",      "context", "shaders", "lists",  "prepare", "trace",
                                                                 "read back", "resolve", "light",   "encode", "write"};

// Milliseconds spent in each phase; a phase entered twice adds up.
class Timings {
public:
    double& operator[](Phase phase) { return milliseconds_[static_cast<std::size_t>(phase)]; }
    double operator[](Phase phase) const { return milliseconds_[static_cast<std::size_t>(phase)]; }

private:
    std::array<double, phase_names.size()> milliseconds_{};
};

// Adds the time between its construction and destruction to a phase.
class PhaseTimer {
public:
    PhaseTimer(Timings& timings, Phase phase) : timings_(timings), phase_(phase) {}
    ~PhaseTimer() {
        timings_[phase_] += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_).count();
    }
    PhaseTimer(const PhaseTimer&) = delete;
    PhaseTimer& operator=(const PhaseTimer&) = delete;

private:
    Timings& timings_;
    Phase phase_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// Returns work(), whose time is added to the phase.
template <typename Work>
auto timed(Timings& timings, Phase phase, const Work& work) {
    const PhaseTimer timer(timings, phase);
    return work();
}

}  // namespace sphereview

// What a piece of work costs, in milliseconds.
#pragma once

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

namespace sphereview {

inline double wall_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// User and system time of all threads.
inline double cpu_ms() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto in_ms = [](const timeval& t) { return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec); };
    return in_ms(usage.ru_utime) + in_ms(usage.ru_stime);
}

struct Cost {
    double wall;
    double cpu;
};

// Medians over `runs` calls, after one that warms up.
template <typename Work>
Cost median_cost(int runs, const Work& work) {
    work();
    std::vector<double> wall;
    std::vector<double> cpu;
    for (int i = 0; i < runs; ++i) {
        const double wall_begin = wall_ms();
        const double cpu_begin = cpu_ms();
        work();
        wall.push_back(wall_ms() - wall_begin);
        cpu.push_back(cpu_ms() - cpu_begin);
    }
    const auto median = [](std::vector<double>& values) {
        std::ranges::sort(values);
        return values[values.size() / 2];
    };
    return {median(wall), median(cpu)};
}

inline void print(const char* what, const Cost& cost) {
    std::printf("\"%s\": {\"wall_ms\": %.3f, \"cpu_ms\": %.3f}, ", what, cost.wall, cost.cpu);
}

}  // namespace sphereview

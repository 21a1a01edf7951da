// Waiting for a condition.
#pragma once

#include <chrono>
#include <thread>

namespace sphereview::test {

// Whether the condition came true within a time that no healthy run needs, not even a sanitized one on a busy machine.
template <typename Condition>
bool eventually(const Condition& condition, std::chrono::milliseconds limit = std::chrono::seconds(180)) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!condition()) {
        if (std::chrono::steady_clock::now() >= end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

}  // namespace sphereview::test

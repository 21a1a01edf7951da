// How many random trials a test does.
#pragma once

namespace sphereview::test {

// A quarter of `count` with sanitizers, with which each trial takes several times as long.
#ifdef SPHEREVIEW_SANITIZED
constexpr int trials(int count) { return (count + 3) / 4; }
#else
constexpr int trials(int count) { return count; }
#endif

}  // namespace sphereview::test

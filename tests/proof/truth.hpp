// What a trial's ray really meets, in 256 bits: so far beyond the bounds under test that it may be called true.
#pragma once

#include "exact/filter.hpp"
#include "proof/trial.hpp"

namespace sphereview {

struct Truth {
    EyeSide side = EyeSide::outside;
    bool hit = false;
    double distance = 0.0;   // of the hit, along the ray, in scene units; correctly rounded
    glm::dvec3 point{0.0};   // of the hit, relative to the eye; likewise
    double condition = 0.0;  // (|forward| + |across right| + |upward up|) / |ray|
};

Truth true_hit(const Trial& trial);

// Whether what the filter says of the trial is so: the hit lies within its bounds, what is missed is missed, what is
// surely hit is hit. `low` and `high` are HitBounds in scene units.
bool claims_hold(const Truth& truth, double low, double high);

}  // namespace sphereview

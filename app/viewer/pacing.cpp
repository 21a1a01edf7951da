#include "viewer/pacing.hpp"

namespace sphereview {

void Pacing::traced(int step, double seconds) {
    const double full = seconds * step * step;
    // Follows a slower frame at once, a faster one slowly: a coarse frame has costs that do not shrink with its pixels.
    seconds_per_full_frame_ = full > seconds_per_full_frame_ ? full : 0.7 * seconds_per_full_frame_ + 0.3 * full;
}

int Pacing::moving_step() const {
    int step = 1;
    while (step < 8 && seconds_per_full_frame_ > frame_budget * step * step) step *= 2;
    return step;
}

}  // namespace sphereview

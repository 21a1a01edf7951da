#include "viewer/pacing.hpp"

namespace sphereview {

namespace {

// Follows a slower frame at once, a faster one slowly: a coarse drawing has costs, too, that do not shrink with its pixels.
void follow(double& known, double measured) { known = measured > known ? measured : 0.7 * known + 0.3 * measured; }

}  // namespace

void Pacing::traced(int step, double seconds, double drawing) {
    follow(drawing_full_, drawing * step * step);
    follow(preparing_, seconds - drawing);
}

int Pacing::moving_step() const {
    int step = 1;
    while (step < 8 && preparing_ + drawing_full_ / (step * step) > frame_budget) step *= 2;
    return step;
}

}  // namespace sphereview

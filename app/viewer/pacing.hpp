// When to draw, and how coarsely, so that a drag is answered at once on every device and an idle window costs nothing.
#pragma once

#include <optional>

namespace sphereview {

// The picture is traced for every step-th pixel of each row and column.
class Pacing {
public:
    // What a traced frame took, in seconds, and what of it was drawing: the rest, lists mostly, shrinks little with the pixels.
    // Both are weighed apart: a finer grid costs more of the one than of the other.
    void traced(int step, double seconds, double drawing) {
        follow(drawing_full_, drawing * step * step);
        follow(preparing_, seconds - drawing);
    }

    // The step for a picture that is moving: 1 where the device is fast enough, at most 8.
    int moving_step() const {
        int step = 1;
        while (step < 8 && preparing_ + drawing_full_ / (step * step) > frame_budget) step *= 2;
        return step;
    }

    // Something happened: some frames must be drawn, until the panels have settled.
    void touch() { frames_ = settling_frames; }
    // There is another picture to show, which changes nothing of the panels.
    void show_once() { frames_ = frames_ > 0 ? frames_ : 1; }
    // A frame was drawn.
    void drew(int step) {
        if (frames_ > 0) --frames_;
        coarse_ = step > 1;
    }

    // Nothing is to be drawn before the next event.
    bool rests() const { return frames_ == 0 && !coarse_; }
    // How long to wait for events before the next frame; nothing: until one comes.
    std::optional<double> patience() const {
        if (frames_ > 0) return 0.0;
        return coarse_ ? std::optional(refine_after) : std::nullopt;
    }
    // Whether nothing moves in the frame that comes: time to make the picture fine.
    bool refines() const { return frames_ == 0 && coarse_; }

    static constexpr double frame_budget = 0.016;  // seconds for the trace of a moving picture
    static constexpr double refine_after = 0.08;   // seconds without an event
    static constexpr double look_again = 0.01;     // seconds, while another thread works

private:
    // Follows a slower frame at once, a faster one slowly: a coarse drawing has costs, too, that do not shrink with its pixels.
    static void follow(double& known, double measured) { known = measured > known ? measured : 0.7 * known + 0.3 * measured; }

    // ImGui shows what a click did in the next frame, and places what is new in the one after that.
    static constexpr int settling_frames = 3;

    int frames_ = settling_frames;
    bool coarse_ = false;
    double preparing_ = 0.0;     // seconds, at the last step
    double drawing_full_ = 0.0;  // all pixels
};

}  // namespace sphereview

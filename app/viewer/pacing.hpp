// When to draw, and how coarsely, so that a drag is answered at once on every device and an idle window costs nothing.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

namespace sphereview {

// The picture is traced for every step-th pixel of each row and column.
class Pacing {
public:
    // What a traced frame took, in seconds, and what of it was drawing: the rest, lists mostly, shrinks little with the pixels.
    void traced(int step, double seconds, double drawing) {
        const std::size_t now = level_of(step);
        const double before = seconds_at(now);
        Level& level = levels_[now];
        level = {follow(level.preparing, seconds - drawing), follow(level.drawing, drawing), true};
        // Finer pictures have become slower or faster too, by as much. And what they took is believed less and less, so that one is
        // tried again now and then.
        const double factor = fading * (before > 0.0 ? seconds_at(now) / before : 1.0);
        for (std::size_t finer = 0; finer < now; ++finer) {
            levels_[finer].preparing *= factor;
            levels_[finer].drawing *= factor;
        }
    }

    // The step for a picture that is moving: 1 where the device is fast enough, at most 8; and no coarser than saves time.
    int moving_step() const {
        std::size_t level = 0;
        while (level + 1 < levels_.size() && seconds_at(level) > frame_budget &&
               seconds_at(level + 1) < worth_it * seconds_at(level)) {
            ++level;
        }
        return 1 << level;
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

    // Seconds for the trace of a moving picture; with what shows it, about 30 ms a frame.
    static constexpr double frame_budget = 0.024;
    static constexpr double refine_after = 0.08;  // seconds without an event
    static constexpr double look_again = 0.01;    // seconds, while another thread works

private:
    // Of a step, in seconds.
    struct Level {
        double preparing = 0.0;
        double drawing = 0.0;
        bool known = false;
    };
    static constexpr std::size_t level_of(int step) {
        return static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(step)));
    }

    // Follows a slower frame at once, but for one that something else held up, and a faster one slowly.
    static double follow(double known, double measured) {
        if (!(known > 0.0)) return measured;
        return measured > known ? std::min(measured, 2.0 * known) : 0.7 * known + 0.3 * measured;
    }

    // What a picture of that level would take.
    double seconds_at(std::size_t level) const {
        const Level& own = levels_[level];
        if (own.known) return own.preparing + own.drawing;
        std::size_t coarser = level;
        while (coarser < levels_.size() && !levels_[coarser].known) ++coarser;
        std::size_t finer = level;
        while (finer > 0 && !levels_[finer].known) --finer;
        const bool has_coarser = coarser < levels_.size();
        const bool has_finer = levels_[finer].known;
        const auto pixels = [](std::size_t of_level) { return std::ldexp(1.0, -2 * static_cast<int>(of_level)); };
        // A coarse drawing has costs that do not shrink with its pixels: between two that are known they are known too.
        if (has_coarser && has_finer) {
            const double part = (pixels(level) - pixels(coarser)) / (pixels(finer) - pixels(coarser));
            return std::max(levels_[coarser].preparing, levels_[finer].preparing) + levels_[coarser].drawing +
                   part * (levels_[finer].drawing - levels_[coarser].drawing);
        }
        if (has_coarser) {
            return levels_[coarser].preparing + levels_[coarser].drawing * pixels(level) / pixels(coarser);
        }
        // Fewer spheres are listed for fewer rays: how many fewer is not known before it is tried.
        if (has_finer) {
            return (levels_[finer].preparing + levels_[finer].drawing) * pixels(level) / pixels(finer);
        }
        return 0.0;
    }

    static constexpr double fading = 0.985;
    static constexpr double worth_it = 0.9;

    // ImGui shows what a click did in the next frame, and places what is new in the one after that.
    static constexpr int settling_frames = 3;

    int frames_ = settling_frames;
    bool coarse_ = false;
    std::array<Level, 4> levels_{};  // of the steps 1, 2, 4 and 8
};

}  // namespace sphereview

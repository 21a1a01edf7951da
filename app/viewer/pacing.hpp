// When to draw, and how coarsely, so that a drag is answered at once on every device and an idle window costs nothing.
#pragma once

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

namespace sphereview {

// The picture is traced for every step-th pixel of each row and column.
class Pacing {
public:
    // Notes the seconds of a traced redraw and the part of it that was drawing; the rest, lists mostly, shrinks less with the
    // pixels. A redraw that takes too long makes the next one coarser at once. What a finer one would take is tried, ever less
    // often when that fails, because a coarse drawing has costs that do not shrink with its pixels.
    void traced(int step, double seconds, double drawing) {
        const int level = std::countr_zero(static_cast<unsigned>(step));
        if (level < level_) {  // nothing moved: the picture was refined
            if (seconds <= budget_) level_ = level;
            return;
        }
        if (level > level_) {  // the first parts of a finer one took too long (LivePicture::update)
            if (std::exchange(tries_, false)) pause();
            level_ = level;
            left_seconds_ = 0.0;
            return;
        }
        if (stays_ > 0) --stays_;
        const double before = std::exchange(left_seconds_, 0.0);
        if (before > 0.0 && seconds > worth_it * before) {
            level_ = left_level_;  // coarser saves no time
            stays_ = long_pause;
        } else if (seconds > budget_) {
            if (level < coarsest && stays_ == 0) become_coarser(seconds, drawing);
        } else {
            if (std::exchange(tries_, false)) pause_ = wait_ = 0;
            if (wait_ > 0) --wait_;
            const double most = seconds - drawing + 4.0 * drawing;
            if (level > 0 && (most <= budget_ || wait_ == 0)) {
                --level_;
                tries_ = true;
            }
        }
    }

    // The step for a moving picture: 1 on a fast device, at most 8 or what was traced instead, and no coarser than saves time.
    int moving_step() const { return 1 << level_; }

    // Seconds for the trace of a moving picture.
    double budget() const { return budget_; }
    // Call while a film plays: redraws are to come film_rate times a second. `besides`: a redraw's seconds besides the trace.
    // `settles`: the next frames come soon enough for the panels to settle in their redraws.
    void play(double besides, bool settles) {
        settles_ = settles;
        besides_ += (besides - besides_) * (besides_ == 0.0 ? 1.0 : 0.1);
        budget_ = std::clamp(film_part / film_rate - besides_, least_budget, redraw_budget);
    }
    void end_play() {
        settles_ = false;
        besides_ = 0.0;
        budget_ = redraw_budget;
    }

    // Something happened: draw until the panels have settled.
    void touch() {
        redraws_ = settles_ ? 1 : settling_redraws;
        more_ = settles_ ? 0 : most_more;
        goes_on_ = false;
    }
    // There is another picture to show, which does not change the panels.
    void show_once() { redraws_ = redraws_ > 0 ? redraws_ : 1; }
    // A redraw was drawn. `panels_changed`: its panels differ from the redraw before, so they may not have settled yet.
    void drew(int step, bool panels_changed = false) {
        if (redraws_ > 0) --redraws_;
        if (redraws_ == 0 && panels_changed && more_ > 0) {
            --more_;
            redraws_ = 1;
        }
        coarse_ = step > 1;
        goes_on_ = false;
    }
    // A part of a fine picture was drawn; there are others.
    void refined_a_part() { goes_on_ = true; }

    // Whether everything that happened is shown.
    bool is_settled() const { return redraws_ == 0; }
    // Whether nothing is to be drawn before the next event.
    bool rests() const { return redraws_ == 0 && !coarse_; }
    // Seconds to wait for events before the next redraw; nothing: until an event comes.
    std::optional<double> patience() const {
        if (redraws_ > 0) return 0.0;
        if (!coarse_) return std::nullopt;
        return goes_on_ ? 0.0 : refine_after;
    }
    // Whether to refine the picture: nothing moves, and it is coarse.
    bool refines() const { return redraws_ == 0 && coarse_; }

    // Seconds for the trace of a moving picture; with what shows it, about 30 ms a redraw.
    static constexpr double redraw_budget = 0.024;
    static constexpr double film_rate = 24.0;     // redraws a second, at least
    static constexpr double refine_after = 0.08;  // seconds without an event
    // Seconds for drawing a fine picture before the next look for events.
    static constexpr double refine_budget = 0.016;
    static constexpr double look_again = 0.01;  // seconds, while another thread works

private:
    static constexpr int coarsest = 3;        // the step is 2^3
    static constexpr double film_part = 0.9;  // of the time between two redraws, for the redraw itself
    static constexpr double least_budget = 0.005;
    static constexpr double worth_it = 0.9;
    static constexpr int short_pause = 60;  // redraws
    static constexpr int long_pause = 480;

    // A finer redraw was tried and took too long.
    void pause() { wait_ = pause_ = std::clamp(2 * pause_, short_pause, long_pause); }

    void become_coarser(double seconds, double drawing) {
        if (std::exchange(tries_, false)) pause();
        left_level_ = level_;
        left_seconds_ = seconds;
        double lists = seconds - drawing;
        do {
            ++level_;
            lists *= 0.5;
            drawing *= 0.25;
        } while (level_ < coarsest && lists + drawing > budget_);
    }

    // ImGui shows a click's effect in the next redraw, and places new widgets in the one after that.
    static constexpr int settling_redraws = 3;
    // A scroll bar changes its content's width, and so its height, which may take more redraws. Bounded, in case they alternate for
    // ever.
    static constexpr int most_more = 8;

    int redraws_ = settling_redraws;
    int more_ = most_more;  // redraws that may be added while panels change
    bool coarse_ = false;
    bool goes_on_ = false;       // a part of the fine picture is drawn, more follow
    int level_ = 0;              // the step of what moves is 2^this
    bool tries_ = false;         // the last redraw was made finer
    int wait_ = 0;               // redraws before the next try
    int pause_ = 0;              // redraws that wait_ began with after the last failed try
    int left_level_ = 0;         // the level before the last redraw was made coarser
    double left_seconds_ = 0.0;  // what a redraw took at that level; 0: not made coarser
    int stays_ = 0;              // redraws that are not made coarser yet
    bool settles_ = false;       // in the redraws of a film
    double budget_ = redraw_budget;
    double besides_ = 0.0;  // recent seconds of a film's redraw besides the trace; 0: none yet
};

}  // namespace sphereview

// A progress bar.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace sphereview {

// A bar on standard error, shown if that is a terminal and the work takes longer than half a second. One at a time, used from one
// thread. Destruction clears it.
class Progress {
public:
    Progress();
    // Shows nothing, and calls `watcher` with each fraction instead, in any thread. update() throws what it throws.
    explicit Progress(std::function<void(double fraction)> watcher);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // Begins a bar for `what`, such as "scene.txt (2 of 5)". If all is `amount` units, such as 70 "MB", the rate is shown too.
    void start(std::string what, double amount = 0.0, std::string unit = "");
    // Shows the finished fraction, 0..1, and `note`. Cheap: draws at most ten times a second.
    void update(double fraction, const std::string& note = "");
    // Removes the bar for other output; update() draws it again.
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    bool enabled_;
    std::function<void(double)> watcher_{};
    bool drawn_ = false;
    std::string what_;
    double amount_ = 0.0;
    std::string unit_;
    Clock::time_point begin_;
    Clock::time_point drawn_at_;
};

}  // namespace sphereview

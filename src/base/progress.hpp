// A progress bar for people who wait.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace sphereview {

// A bar on standard error, shown when that is a terminal and the work has taken longer than half a second; silent otherwise.
// One at a time, used from one thread. Destruction clears it.
class Progress {
public:
    Progress();
    // Shows nothing, and tells `watcher` each fraction instead, also from another thread than that of the terminal. What it throws
    // comes out of update().
    explicit Progress(std::function<void(double fraction)> watcher);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // What is being done, e.g. "scene.txt (2 of 5)". Starts the fraction anew. When all of it is `amount` units, e.g. 70 "MB",
    // the rate is shown too.
    void start(std::string what, double amount = 0.0, std::string unit = "");
    // How much of it is done, 0..1; `note` is shown with it. Cheap: draws at most ten times a second.
    void update(double fraction, const std::string& note = "");
    // Removes the bar, so that something else can be printed; update() draws it again.
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

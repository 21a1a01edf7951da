#include "base/progress.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "base/interrupt.hpp"
#include "base/standard_streams.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

constexpr std::chrono::milliseconds patience{500};  // shorter work needs no bar
constexpr std::chrono::milliseconds redraw_every{100};

std::string three_digits(double value) { return fixed(value, value < 10 ? 2 : value < 100 ? 1 : 0); }

}  // namespace

Progress::Progress() : enabled_(stderr_is_terminal()) {}

Progress::Progress(std::function<void(double)> watcher) : enabled_(false), watcher_(std::move(watcher)) {}

Progress::~Progress() { clear(); }

void Progress::start(std::string what, double amount, std::string unit) {
    what_ = on_one_line(what);
    amount_ = amount;
    unit_ = std::move(unit);
    begin_ = Clock::now();
}

void Progress::update(double fraction, const std::string& note) {
    if (watcher_) watcher_(fraction);
    if (!enabled_) return;
    const auto now = Clock::now();
    if (now - begin_ < patience || (drawn_ && now - drawn_at_ < redraw_every)) return;
    fraction = std::clamp(fraction, 0.0, 1.0);

    constexpr int width = 30;
    std::string bar(static_cast<std::size_t>(fraction * width), '#');
    bar.resize(width, '.');
    const double elapsed = std::chrono::duration<double>(now - begin_).count();
    const double left = fraction > 0 ? elapsed / fraction - elapsed : 0;
    const std::string rate = amount_ > 0 ? three_digits(amount_ * fraction / elapsed) + " " + unit_ + "/s, " : "";
    set_progress_bar_shown(true);
    std::fprintf(stderr, "\r\x1b[K[%s] %3.0f %%, %s%s%.0f s left  %s", bar.c_str(), 100 * fraction, rate.c_str(), note.c_str(),
                 left, what_.c_str());
    std::fflush(stderr);
    drawn_ = true;
    drawn_at_ = now;
}

void Progress::clear() {
    if (!drawn_) return;
    std::fputs("\r\x1b[K", stderr);
    std::fflush(stderr);
    drawn_ = false;
    set_progress_bar_shown(false);
}

}  // namespace sphereview

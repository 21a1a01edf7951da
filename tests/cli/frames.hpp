// Pictures of several frames.
#pragma once

#include <gtest/gtest.h>

#ifdef __linux__
#include <sched.h>
#endif

#include <string>
#include <vector>

#include "cli/in_folder.hpp"
#include "support/render.hpp"

namespace sphereview::test {

// Frames of an atom that moves along x.
inline std::string moving_atom(int frames) {
    std::string text;
    for (int i = 0; i < frames; ++i) text += "1\n\nO " + std::to_string(i) + " 0 0\n";
    return text;
}

class Frames : public InFolder {
protected:
    Outcome render(const std::vector<std::string>& arguments) const { return test::render(folder_, arguments); }

    void expect_done(const std::vector<std::string>& arguments) const {
        const Outcome outcome = render(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome;
        EXPECT_EQ(outcome.errors, "");
    }

    Picture picture(const std::string& name) const { return decode_png(folder_.read(name)); }
};

#ifdef __linux__

// Children of this process have one core while it lives.
class OneCore {
public:
    OneCore() {
        sched_getaffinity(0, sizeof before_, &before_);
        int first = 0;
        while (!CPU_ISSET(first, &before_)) ++first;
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(first, &one);
        sched_setaffinity(0, sizeof one, &one);
    }
    ~OneCore() { sched_setaffinity(0, sizeof before_, &before_); }
    OneCore(const OneCore&) = delete;
    OneCore& operator=(const OneCore&) = delete;

private:
    cpu_set_t before_{};
};

#endif

}  // namespace sphereview::test

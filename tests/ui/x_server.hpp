// An X server without a screen, for one test.
#pragma once

#include <memory>
#include <string>

#include "support/program.hpp"

namespace sphereview::test {

struct ScreenOptions {
    int width = 1400;
    int height = 1000;
    int dpi = 96;  // twice as many: a screen on which text is twice as large
};

// Xvfb on a display of its own, until destruction.
class XServer {
public:
    explicit XServer(const ScreenOptions& options = {});

    // ":99"
    const std::string& display() const { return display_; }
    // As a crash would.
    void kill();

private:
    std::unique_ptr<Running> xvfb_;
    std::string display_;
};

}  // namespace sphereview::test

// Writes a JSON line for each redraw, for programs that drive the window: its widgets' places, what it shows, whether it rests.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "viewer/layout.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

struct LoggedRedraw {
    std::uint64_t number = 0;
    std::uint64_t builds = 0;        // how often the picture's lists were built from nothing
    std::uint64_t explanations = 0;  // how often a pixel's arithmetic was made for the inspector
    bool exact = false;              // the picture is what `render` writes
    bool making = false;             // that picture is being made
    std::optional<double> draft;     // seconds from the picture's beginning to its shown draft
    bool resting = false;            // the next redraw comes with the next event
    Rectangle picture;
    double seconds = 0.0;  // from the redraw's first event to the swap
    std::string title;
};

class RedrawLog {
public:
    // Does nothing for an empty path. Throws OutputError.
    explicit RedrawLog(const std::string& path);

    bool wanted() const { return file_ != nullptr; }
    // `facts`: of the picture that the redraw shows.
    void add(const ViewerState& state, const RedrawFacts& facts, const LoggedRedraw& redraw, const WidgetRectangles& widgets);

private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

}  // namespace sphereview

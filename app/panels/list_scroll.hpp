// Scrolling in rows: ImGui scrolls in float pixels, which cannot tell neighbours apart behind a million rows.
#pragma once

#include <cstddef>
#include <optional>

#include "panels/panel_context.hpp"

namespace sphereview {

class ListScroll {
public:
    // How many rows there are, and how many are seen at a time (a part of one counts). The last row can just be seen whole. The
    // row that show() was for stays in sight when fewer are seen: the editor below grows with what is selected.
    void set_size(std::size_t rows, double seen);

    // How many rows, or parts of one, are above what is seen.
    double above() const { return above_; }
    double most() const;
    bool is_needed() const { return most() > 0.0; }

    void by(double rows) { to(above_ + rows); }
    void to(double above);  // at most most()
    // By as much that the row is seen; where it is not, into the middle.
    void show(std::size_t row);

    // A scroll bar at a place in screen coordinates, for the mouse. Noted as "list scroll bar".
    void draw_bar(const PanelContext& context, float left, float top, float width, float height);

private:
    double rows_ = 0.0;
    double seen_ = 1.0;
    double above_ = 0.0;
    std::optional<std::size_t> shown_;
    float grabbed_ = 0.0F;  // where in the thumb the mouse holds it, from its top
};

}  // namespace sphereview

// What is drawn over the picture of what the mouse does in it: the box that selects, the point that the view turns about, the
// pinned pixels; and the edge of an export.
#pragma once

#include <imgui.h>

#include <glm/vec2.hpp>

#include "panels/panel_context.hpp"

namespace sphereview {

struct ViewerState;
class MouseControl;

// The layer behind ImGui's windows, cut off at the picture's edges while this lives.
class OverPicture {
public:
    explicit OverPicture(const Rectangle& picture) : list_(*ImGui::GetBackgroundDrawList()) {
        list_.PushClipRect({picture.x, picture.y}, {picture.x + picture.width, picture.y + picture.height});
    }
    ~OverPicture() { list_.PopClipRect(); }
    OverPicture(const OverPicture&) = delete;
    OverPicture& operator=(const OverPicture&) = delete;

    ImDrawList* operator->() const { return &list_; }
    ImDrawList& list() const { return list_; }

private:
    ImDrawList& list_;
};

// Where a place in the picture is on the screen. `pixels`: of a screen coordinate.
ImVec2 on_screen(const Rectangle& picture, double pixels, const glm::dvec2& place);

// The box, the point and the pins, where they are.
void draw_pointer_marks(const ViewerState& state, const MouseControl& mouse, const Rectangle& picture, double pixels, float scale);

// Marks what an export shows of the picture, where that is not all. Not over rays in space.
void draw_export_area(const ViewerState& state, const Rectangle& picture);

}  // namespace sphereview

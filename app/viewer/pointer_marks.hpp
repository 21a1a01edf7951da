// Marks over the picture: the selection box, the point that the view turns about, pinned pixels, and the edge of an export.
#pragma once

#include <imgui.h>

#include <glm/vec2.hpp>

#include "panels/panel_context.hpp"

namespace sphereview {

struct ViewerState;
class MouseControl;

// The layer behind ImGui's windows, clipped to the picture while this lives.
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

// A place of the picture in screen coordinates. `pixels`: a screen coordinate's.
ImVec2 on_screen(const Rectangle& picture, double pixels, const glm::dvec2& place);

// Draws the box, the point and the pins.
void draw_pointer_marks(const ViewerState& state, const MouseControl& mouse, const Rectangle& picture, double pixels, float scale);

// Marks the part of the picture that an export shows, unless that is all. Not over rays in space.
void draw_export_area(const ViewerState& state, const Rectangle& picture);

}  // namespace sphereview

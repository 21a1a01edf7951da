// Draws the axes, which can be clicked and dragged, the scale bar and other marks over the window's picture, with the lines of an
// export (app/picture_marks.hpp) in the size of the window's text; and the selection box, the point that the view turns about,
// pinned pixels, and the edge of an export.
#pragma once

#include <imgui.h>

#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "app/picture_marks.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

class MouseControl;
struct ViewerState;

// A drag of the axes.
struct AxesInHand {
    bool turns = false;          // the pointer has left the place of the press
    ImVec2 applied{0.0F, 0.0F};  // the pointer's way when the view was turned last
};

// Call after the panels; `picture`: the place that they leave. `pixels`: a screen coordinate's. A click on an axis' end turns the
// view to look along that axis from there, or, if it does already, from the other end. A drag turns it about the pivot. Widgets:
// "axes" and, for each end, "axis +x", "axis -z".
void draw_view_marks(ViewerState& state, const PanelContext& context, const Rectangle& picture, double pixels);

// Draws lines between the measured spheres, and the measures beside them.
void draw_measured(const ViewerState& state, const PanelContext& context, const Rectangle& picture, double pixels);

// The screen places of those measured centres that are in front of the eye.
std::vector<ImVec2> measured_places(const ViewerState& state, const Rectangle& picture);

// The last places of axes, scale bar, legend and the rays' panel, moved to the picture's present place.
std::vector<Rectangle> places_of_marks(const ViewerState& state, const Rectangle& picture);

// "axes, scale bar and legend", as far as the window shows them; "" for none.
std::string shown_marks(const ViewerState& state);

// The marks that an export of the view gets.
PictureMarks exported_marks(const ViewerState& state);

// Draws strokes on the screen, relative to `origin`.
void draw_strokes(std::span<const Stroke> strokes, ImVec2 origin, double pixels);

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

// What the window draws over its picture to say which way it looks and how large things are: the axes, which can be clicked and
// dragged, and the scale bar. The same lines as in an export (app/picture_marks.hpp), as large as the window's text asks.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/picture_marks.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

struct ViewerState;

// The axes in the hand.
struct AxesInHand {
    bool turns = false;          // the pointer has left the place where it went down
    ImVec2 applied{0.0F, 0.0F};  // how far it had moved when the view was turned last
};

// To be called after the panels: `picture` is what they leave. `pixels`: of a screen coordinate. A click on an axis' end turns the
// view until it looks along that axis from there, or from the other end where it does already; a drag turns it about the pivot.
// Widgets: "axes" and, for each end, "axis +x", "axis -z".
void draw_view_marks(ViewerState& state, const PanelContext& context, const Rectangle& picture, double pixels);

// Draws lines between the spheres that are measured, and beside them what they measure.
void draw_measured(const ViewerState& state, const PanelContext& context, const Rectangle& picture, double pixels);

// Where the measured spheres' centres are seen, those before the eye.
std::vector<ImVec2> measured_places(const ViewerState& state, const Rectangle& picture);

// Where axes, scale bar, legend and the rays' panel were drawn last, in the picture's present place.
std::vector<Rectangle> places_of_marks(const ViewerState& state, const Rectangle& picture);

// "axes, scale bar and legend", as far as the window shows them; "" for none.
std::string shown_marks(const ViewerState& state);

// The marks that an export of the view gets.
PictureMarks exported_marks(const ViewerState& state);

// Strokes from `origin` on, on the screen.
void draw_strokes(std::span<const Stroke> strokes, ImVec2 origin, double pixels);

}  // namespace sphereview

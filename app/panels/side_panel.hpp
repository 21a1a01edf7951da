// The list of spheres, the editor of the selected ones, and panels for the rest of the scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edit/selection.hpp"
#include "panels/listed_spheres.hpp"
#include "panels/look_panel.hpp"
#include "panels/number_field.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

// The selected spheres' values, in order, when a drag of a field began. A drag moves from these, not from the last redraw's, so
// errors do not add up and the way back is exact.
struct ValueDrag {
    std::uint64_t gesture = 0;
    std::uint64_t selection = 0;  // its version
    std::vector<double> values;
    std::size_t primary = 0;  // the place of the value that the field shows
};

// The camera when a drag of one of its numbers began.
struct CameraDrag {
    std::uint64_t gesture = 0;
    Camera camera;
};

// The light when a drag of the sun began, and the scene's last sun.
struct SunDrag {
    Light light;
    std::optional<Sun> last_sun{};
    bool cancelled = false;  // by Escape; the rest of the drag does nothing
};

// A name that is being typed in a list.
struct Renaming {
    std::optional<std::size_t> of{};  // the sphere's number, or the view's place
    std::string name{};
    bool focus = false;  // the box gets the keyboard

    void start(std::size_t number, const std::string& present) { *this = {number, present, true}; }
};
// Draws the box. Returns whether to take the name; Escape has restored the present one.
bool draw_renaming(const PanelContext& context, Renaming& renaming, const char* widget);

// The part whose heading was clicked last, until the pointer moves. When the list above makes room for an opening part, its heading
// moves away from the pointer; a further click there, as of a double click, is still for this heading.
struct ToggledPart {
    std::string part;
    ImVec2 at;  // on the screen
    bool open = false;
    bool clicked_again = false;  // since the heading was drawn
};

// The part that was opened last, until the pointer leaves the panel. If its contents have room below, its heading stays in place
// and the parts behind it go down.
struct OpenedPart {
    std::string part;
    float heading = 0.0F;  // its upper edge on the screen, in the last redraw
    float end = 0.0F;      // the lower edge of its contents
    int redraws = 0;       // since it was opened
    bool has_room = true;  // below its heading
};

// The side panel's state.
struct SidePanelState {
    std::string filter;
    Renaming renaming;                 // of a sphere
    FilterSearch search;               // for the filter; goes on from redraw to redraw
    std::uint64_t searched = 0;        // Document::names_revision() of the search, or revision() of a condition
    bool scroll_to_selection = false;  // set by selections elsewhere
    ListScroll scroll;
    bool list_hovered = false;   // the wheel scrolls the list
    bool list_has_keys = false;  // the list was clicked last: Home, End, Page Up and Page Down move in it

    std::optional<std::uint32_t> anchor;   // the row clicked last, where a range of rows begins
    std::optional<std::uint32_t> dragged;  // the sphere that is dragged to another row
    bool drag_cancelled = false;
    std::uint64_t drawn_revision = 0;     // of the scene with these numbers
    std::optional<std::uint32_t> edited;  // the sphere that the fields below show
    NumberFields numbers;
    ValueDrag value_drag;
    CameraDrag camera_drag;
    SharedValues shared;  // of the scene and the selection of these revisions
    std::uint64_t shared_revision = 0;
    std::uint64_t shared_selection = 0;
    std::string name;
    bool name_active = false;
    bool open_camera = false;  // its part is opened in the next redraw
    Renaming renamed_view;
    std::string view_fault;  // why the last name was refused
    // Whether a text box is about to get the keyboard, which takes a redraw or two.
    bool opens_box() const { return numbers.focus || renamed_view.focus; }
    // Whether a text box is there, or opens.
    bool has_box() const { return !numbers.typed.empty() || renamed_view.of; }

    LookPanelState look;

    std::optional<ToggledPart> toggled{};
    std::optional<OpenedPart> opened{};
    std::optional<Sun> last_sun;  // the scene's last sun, to switch it on again
    SunDrag sun_drag;
    float below_list = 0.0F;   // height of all below the list
    float list_height = 0.0F;  // in the last redraw; 0: none
};

// Draws into the current ImGui window.
void draw_side_panel(const PanelContext& context, SidePanelState& state);

// Whether the search is of the present filter and document.
bool is_searched(const Document& document, const SidePanelState& state);

// Begins typing the name of a sphere in the list.
void start_renaming(SidePanelState& state, const Scene& scene, std::uint32_t number);

// A step that saves the camera as a view of the scene, under the first free name of "view 1", "view 2" and so on.
EditScene saved_view_of(const Scene& scene, const Camera& camera);
// Begins typing the name of a saved view, and opens the part for views.
void start_renaming_view(SidePanelState& state, const Scene& scene, std::size_t view);

// The list is as wide as the window and scrolls in itself. It works for visible rows alone, and for changes when there is a filter.
void draw_sphere_list(const PanelContext& context, SidePanelState& state, float height);

// The editor of all selected spheres. Where values differ it shows the ranges, and the primary sphere's colour. A drag changes all
// by the same difference or factor; a typed number is set for all. Each is one step.
void draw_sphere_editor(const PanelContext& context, SidePanelState& state);

// The scene's light, with the sun as a handle on a ball that is lit as the view sees it.
void draw_light_panel(const PanelContext& context, SidePanelState& state);

// The view's camera in numbers. An edit makes it the scene's camera.
void draw_camera_panel(const PanelContext& context, SidePanelState& state);

// The scene's saved views, to show, rename, replace by the present view, and delete.
void draw_saved_views(const PanelContext& context, SidePanelState& state);

// The selected spheres' common values, kept until the scene or the selection changes; none while the selection is not of this
// scene.
const SharedValues& shared_of_selection(const PanelContext& context, SidePanelState& state);

}  // namespace sphereview

// The list of spheres, the editor of the selected ones, and what else a scene holds.
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

// The values of a number's field when its drag began, of the selected spheres in order. A drag moves from these and not from the
// last redraw's: nothing adds up, and back is back to the bit.
struct ValueDrag {
    std::uint64_t gesture = 0;
    std::uint64_t selection = 0;  // its version
    std::vector<double> values;
    std::size_t primary = 0;  // the place of the one that the field shows
};

// The camera when the drag of one of its numbers began.
struct CameraDrag {
    std::uint64_t gesture = 0;
    Camera camera;
};

// The light when the sun was taken, and the sun that the scene had last.
struct SunDrag {
    Light light;
    std::optional<Sun> last_sun{};
    bool cancelled = false;  // by Escape: the rest of the drag does nothing
};

// A name that is being typed in a list.
struct Renaming {
    std::optional<std::size_t> of{};  // the sphere's number, or the view's place
    std::string name{};
    bool focus = false;  // its box is to get the keyboard

    void start(std::size_t number, const std::string& present) { *this = {number, present, true}; }
};
// Draws the box. Returns whether the name is to be taken: Escape has given the present one back.
bool draw_renaming(const PanelContext& context, Renaming& renaming, const char* widget);

// The part of the panel whose heading was clicked last, until the pointer moves. As the list above makes room for a part that
// opens, its heading goes from under the pointer: another click there, as of a double click, is still meant for it.
struct ToggledPart {
    std::string part;
    ImVec2 at;  // on the screen
    bool open = false;
    bool clicked_again = false;  // since it was drawn
};

// The part that was opened last, until the pointer has left the panel: where its contents had room below its heading, that stays
// where it was clicked, and what comes after goes down.
struct OpenedPart {
    std::string part;
    float heading = 0.0F;  // its upper edge on the screen, in the last redraw
    float end = 0.0F;      // the lower edge of its contents
    int redraws = 0;       // since it was opened
    bool has_room = true;  // below its heading
};

// What the side panel remembers from redraw to redraw.
struct SidePanelState {
    std::string filter;
    Renaming renaming;                 // of a sphere
    FilterSearch search;               // for the spheres that pass the filter; goes on from redraw to redraw
    std::uint64_t searched = 0;        // Document::names_revision() of the search; of a condition revision()
    bool scroll_to_selection = false;  // set by whoever selects elsewhere
    ListScroll scroll;
    bool list_hovered = false;   // the wheel is the list's
    bool list_has_keys = false;  // Home, End, Page Up and Page Down move in the list, which was clicked last

    std::optional<std::uint32_t> anchor;   // where a range of rows begins: the row clicked last
    std::optional<std::uint32_t> dragged;  // the sphere that is being given another place
    bool drag_cancelled = false;
    std::uint64_t drawn_revision = 0;     // of the scene in which these are numbers
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
    std::string view_fault;  // why the name that was typed last was refused
    // Whether a box for typing has been asked for, and a redraw or two go by until it has the keyboard.
    bool opens_box() const { return numbers.focus || renamed_view.focus; }
    // Whether a box is there, or opens.
    bool has_box() const { return !numbers.typed.empty() || renamed_view.of; }

    LookPanelState look;

    std::optional<ToggledPart> toggled{};
    std::optional<OpenedPart> opened{};
    std::optional<Sun> last_sun;  // what the scene had last, for when it is switched on again
    SunDrag sun_drag;
    float below_list = 0.0F;   // how high what comes below the list was
    float list_height = 0.0F;  // the list's own, in the last redraw; 0: there was none
};

// Draws into the current ImGui window.
void draw_side_panel(const PanelContext& context, SidePanelState& state);

// Whether what was found is of the filter and the document as they are.
bool is_searched(const Document& document, const SidePanelState& state);

// Begins typing the name of a sphere in the list.
void start_renaming(SidePanelState& state, const Scene& scene, std::uint32_t number);

// A step that keeps the camera as a view of the scene, by the first of "view 1", "view 2" and so on that is free.
EditScene saved_view_of(const Scene& scene, const Camera& camera);
// Begins typing the name of a saved view; its part of the panel opens.
void start_renaming_view(SidePanelState& state, const Scene& scene, std::size_t view);

// Its parts, in files of their own. The list is as wide as the window and so high, and scrolls in itself. It does work for the
// visible rows alone, and for what changed when there is a filter.
void draw_sphere_list(const PanelContext& context, SidePanelState& state, float height);

// The editor is of all selected spheres: where their values differ, the ranges are shown, and the colour is
// the primary sphere's. A drag moves all by the same difference or scales all by the same factor; a typed number is set for all.
// Each is one step.
void draw_sphere_editor(const PanelContext& context, SidePanelState& state);

// The scene's light, and the sun as a handle on a ball, which is lit as the view sees it.
void draw_light_panel(const PanelContext& context, SidePanelState& state);

// The view's camera, in numbers. An edit makes it the scene's.
void draw_camera_panel(const PanelContext& context, SidePanelState& state);

// The scene's saved views: to go to, rename, set to what is seen, and delete.
void draw_saved_views(const PanelContext& context, SidePanelState& state);

// What the selected spheres have in common; nothing while the selection is not of the scene. Kept until either changes.
const SharedValues& shared_of_selection(const PanelContext& context, SidePanelState& state);

}  // namespace sphereview

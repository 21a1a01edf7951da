#include "viewer/perform.hpp"

#include "viewer/frame_player.hpp"
#include "viewer/scene_file.hpp"
#include "viewer/scene_properties.hpp"

namespace sphereview {

namespace {

// What an undo or redo concerned is selected; what has gone is not.
void select_touched(ViewerState& state, const Touched& touched) {
    if (!touched.empty()) state.selection.set(touched);
    state.selection.keep_below(state.scene().spheres.size());
    state.side_panel.scroll_to_selection = true;
    state.hovered.reset();
}

// Beside the rays it is the drawn eye that moves, not who looks at it.
void show_scene_camera(ViewerState& state) {
    if (state.rays.on) {
        state.rays.camera = state.scene().camera;
        return;
    }
    state.flight.reset();
    state.camera = state.scene().camera;
}

void take_step(ViewerState& state, bool undoes) {
    Document& document = state.document;
    note_frame_before_edit(state, false);
    const bool moves_view = undoes ? document.undo_moves_view() : document.redo_moves_view();
    const bool follows = moves_view && state.inspected_camera() == state.scene().camera;
    const bool is_look = state.look_steps.contains(undoes ? document.undo_name() : document.redo_name());
    Touched touched;
    const auto step = [&] { touched = undoes ? document.undo() : document.redo(); };
    if (undoes ? document.undo_replaces_scene() : document.redo_replaces_scene()) {
        cross_reload(state, undoes, step);
    } else {
        step();
    }
    if (!is_look) select_touched(state, touched);
    if (follows) show_scene_camera(state);
}

}  // namespace

void undo(ViewerState& state) {
    const Touched before = state.document.selected_before_undo_step();
    take_step(state, true);
    // Spheres that were added are gone; what they were made of, or what else was selected, is in hand again.
    if (!before.empty()) state.selection.set(before);
}

void redo(ViewerState& state) { take_step(state, false); }

void apply(ViewerState& state, EditScene action) {
    const bool adds_or_removes =
        std::holds_alternative<InsertSpheres>(action.edit) || std::holds_alternative<RemoveSpheres>(action.edit);
    const bool reorders = std::holds_alternative<ReorderSphere>(action.edit);
    if (std::holds_alternative<ChangeBackground>(action.edit)) state.background.reset();
    if (std::holds_alternative<ChangeLight>(action.edit)) state.light = {};
    const auto* camera = std::get_if<ChangeCamera>(&action.edit);
    const bool moves_view = camera != nullptr && camera->moves_view;
    if (action.is_look) state.look_steps.insert(action.name);
    note_frame_before_edit(state, adds_or_removes || reorders);
    // Other edits leave the spheres there that they concern.
    Touched before = std::holds_alternative<InsertSpheres>(action.edit) ? state.selection.numbers() : Touched{};
    const std::uint64_t revision = state.document.revision();
    const Touched touched = state.document.apply(std::move(action.edit), std::move(action.name), action.gesture, std::move(before));
    const bool changed = state.document.revision() != revision;
    if (changed && !state.document.can_redo()) state.player.edits.redone.reset();  // nor in other frames
    if (moves_view) show_scene_camera(state);
    if (adds_or_removes) state.selection.clear();
    if (adds_or_removes || reorders) select_touched(state, touched);
}

void perform(ViewerState& state, std::vector<Action> actions) {
    for (Action& action : actions) {
        if (auto* edit = std::get_if<EditScene>(&action)) {
            apply(state, std::move(*edit));
        } else if (auto* select = std::get_if<SelectSpheres>(&action)) {
            state.selection = std::move(select->selection);
            if (select->shows_row) state.side_panel.scroll_to_selection = true;
            state.selection.keep_below(state.scene().spheres.size());
        } else if (const auto* command = std::get_if<RunCommand>(&action)) {
            run_command(state, command->command);
        } else if (const auto* file = std::get_if<OpenFile>(&action)) {
            open_scene(state, file->path);
        } else if (const auto* frame = std::get_if<ShowFrame>(&action)) {
            show_frame(state, frame->frame);
        } else if (const auto* measured = std::get_if<MeasureSphere>(&action)) {
            measure(state.measuring, state.document, measured->number);
        } else if (const auto* view = std::get_if<ShowView>(&action)) {
            fly_to(state, view->camera);
        } else if (std::holds_alternative<RequestProperties>(action)) {
            request_properties(state);
        } else if (const auto* wish = std::get_if<InspectorWish>(&action)) {
            grant(state, *wish);
        } else if (const auto* pinned = std::get_if<PinPixel>(&action)) {
            state.inspector_shown = true;
            state.rays.on = false;
            state.pins = {.first = PinnedPixel{pinned->pixel, pinned->size}};
        }
    }
}

}  // namespace sphereview

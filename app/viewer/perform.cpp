#include "viewer/perform.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "edit/selection.hpp"
#include "viewer/scene_file.hpp"

namespace sphereview {

namespace {

std::string selected_in_words(const ViewerState& state) { return title_of(state.scene(), state.selection); }

// Told apart at a glance, on black and on white.
constexpr std::array<Color, 7> new_colors = {
    {{230, 80, 60}, {70, 140, 230}, {90, 190, 90}, {240, 180, 50}, {160, 100, 210}, {60, 190, 190}, {230, 110, 170}}};

// A sphere of usual size in the middle of the view, in front of what is there.
EditScene add_sphere(const ViewerState& state) {
    const std::size_t count = state.scene().spheres.size();
    Sphere sphere;
    const double depth = std::max(depth_of(state.camera, state.pivot), 0.1);
    const glm::dvec2 middle(0.5 * state.picture_size.width, 0.5 * state.picture_size.height);
    sphere.center = point_at(state.camera, state.picture_size, middle, depth);
    // A tenth of what the picture's shorter side shows there.
    const glm::dvec2 beside = middle + glm::dvec2(0.1 * state.picture_size.shorter_side(), 0.0);
    sphere.radius = glm::distance(point_at(state.camera, state.picture_size, beside, depth), sphere.center);
    sphere.color = new_colors[count % new_colors.size()];
    return {InsertSpheres{{static_cast<std::uint32_t>(count)}, {{sphere, ""}}}, "Add sphere " + std::to_string(count), 0};
}

// Each needs something selected.
EditScene duplicate_selected(const ViewerState& state) {
    InsertSpheres insert;
    auto next = static_cast<std::uint32_t>(state.scene().spheres.size());
    for (const std::uint32_t number : state.selection.numbers()) {
        NamedSphere copy{state.scene().spheres[number], name_of(state.scene(), number)};
        if (!copy.name.empty()) copy.name += " copy";
        // Beside the original, where it can be seen.
        const glm::dvec3 right = state.camera.right;
        copy.sphere.center += copy.sphere.radius / glm::length(right) * right;
        insert.numbers.push_back(next++);
        insert.spheres.push_back(std::move(copy));
    }
    return {std::move(insert), "Duplicate " + selected_in_words(state), 0};
}

EditScene remove_selected(const ViewerState& state) {
    return {RemoveSpheres{state.selection.numbers()}, "Delete " + selected_in_words(state), 0};
}

// Hides them if any is shown, else shows them.
EditScene hide_or_show_selected(const ViewerState& state) {
    const auto& numbers = state.selection.numbers();
    const bool hide = std::ranges::any_of(numbers, [&](std::uint32_t number) { return !state.scene().spheres[number].hidden; });
    ChangeSpheres change{numbers, {}};
    change.spheres.reserve(numbers.size());
    for (const std::uint32_t number : numbers) {
        change.spheres.push_back(state.scene().spheres[number]);
        change.spheres.back().hidden = hide;
    }
    return {std::move(change), (hide ? "Hide " : "Show ") + selected_in_words(state), 0};
}

// By one place in the list, up (-1) or down (1); needs one sphere and a place to go to.
EditScene reorder_selected(const ViewerState& state, int by) {
    const std::uint32_t from = state.selection.numbers().front();
    const std::uint32_t to = by < 0 ? from - 1 : from + 1;
    return {ReorderSphere{from, to}, "Move " + selected_in_words(state) + (by < 0 ? " up" : " down"), 0};
}

// What an undo or redo concerned is selected; what has gone is not.
void select_touched(ViewerState& state, const Touched& touched) {
    if (!touched.empty()) state.selection.set(touched);
    state.selection.keep_below(state.scene().spheres.size());
    state.side_panel.scroll_to_selection = true;
    state.hovered.reset();
}

void scale_text(ViewerState& state, double factor) {
    state.settings.text_scale = text_scale_range.nearest(state.settings.text_scale * factor);
}

void center_on_selection(ViewerState& state) {
    const auto primary = state.selection.primary();
    if (!primary) return;
    state.pivot = state.scene().spheres[*primary].center;
    state.camera = centered_on(state.camera, state.pivot);
}

// What a choice of anti-aliasing means; 0: the command is none.
int samples_of(CommandId command) {
    switch (command) {
        case CommandId::no_anti_aliasing: return 1;
        case CommandId::anti_aliasing_4: return 4;
        case CommandId::anti_aliasing_16: return 16;
        default: return 0;
    }
}

std::optional<Shading> shading_of(CommandId command) {
    if (command < CommandId::first_shading || command > CommandId::last_shading) return std::nullopt;
    return static_cast<Shading>(static_cast<int>(command) - static_cast<int>(CommandId::first_shading));
}

void apply(ViewerState& state, EditScene& action) {
    const bool adds_or_removes =
        std::holds_alternative<InsertSpheres>(action.edit) || std::holds_alternative<RemoveSpheres>(action.edit);
    const bool reorders = std::holds_alternative<ReorderSphere>(action.edit);
    if (std::holds_alternative<ChangeBackground>(action.edit)) state.background.reset();
    const Touched touched = state.document.apply(std::move(action.edit), std::move(action.name), action.gesture);
    if (adds_or_removes) state.selection.clear();
    if (adds_or_removes || reorders) select_touched(state, touched);
}

}  // namespace

bool is_enabled(const ViewerState& state, CommandId command) {
    const std::size_t count = state.scene().spheres.size();
    const auto& selected = state.selection.numbers();
    switch (command) {
        case CommandId::undo: return state.document.can_undo();
        case CommandId::redo: return state.document.can_redo();
        case CommandId::duplicate:
        case CommandId::remove:
        case CommandId::hide:
        case CommandId::select_none:
        case CommandId::select_same_color:
        case CommandId::center_on_selection: return !selected.empty();
        case CommandId::rename: return selected.size() == 1;
        case CommandId::move_up: return selected.size() == 1 && selected.front() > 0;
        case CommandId::move_down: return selected.size() == 1 && selected.front() + 1 < count;
        case CommandId::select_all: return selected.size() < count;
        case CommandId::invert_selection: return count > 0;
        case CommandId::next_frame: return has_frame(state, state.frame + 1);
        case CommandId::previous_frame: return has_frame(state, state.frame - 1);
        case CommandId::use_view_as_camera: return state.camera != state.scene().camera;
        default: return true;
    }
}

bool is_checked(const ViewerState& state, CommandId command) {
    switch (command) {
        case CommandId::toggle_panel: return state.panel_shown;
        case CommandId::toggle_inspector: return state.inspector_shown;
        case CommandId::toggle_export_area: return state.export_area_shown;
        default: return samples_of(command) == state.settings.samples || shading_of(command) == state.settings.shading;
    }
}

void run_command(ViewerState& state, CommandId command) {
    if (!is_enabled(state, command)) return;
    if (const auto shading = shading_of(command)) state.settings.shading = *shading;
    switch (command) {
        case CommandId::first_shading:
        case CommandId::last_shading: return;
        case CommandId::file_new: return new_scene(state);
        case CommandId::file_open: return ask_for_scene(state);
        case CommandId::file_save: return save_scene(state);
        case CommandId::file_save_as: return save_scene_as(state);
        case CommandId::export_picture: return ask_for_export(state);
        case CommandId::export_now: return export_now(state);
        case CommandId::quit: return quit(state);
        case CommandId::undo: return select_touched(state, state.document.undo());
        case CommandId::redo: return select_touched(state, state.document.redo());
        case CommandId::add_sphere: return perform(state, {add_sphere(state)});
        case CommandId::duplicate: return perform(state, {duplicate_selected(state)});
        case CommandId::remove: return perform(state, {remove_selected(state)});
        case CommandId::hide: return perform(state, {hide_or_show_selected(state)});
        case CommandId::move_up: return perform(state, {reorder_selected(state, -1)});
        case CommandId::move_down: return perform(state, {reorder_selected(state, 1)});
        case CommandId::rename: return start_renaming(state.side_panel, state.scene(), state.selection.numbers().front());
        case CommandId::select_all: return state.selection.set_all(state.scene().spheres.size());
        case CommandId::select_none: return state.selection.clear();
        case CommandId::invert_selection: return state.selection.invert(state.scene().spheres.size());
        case CommandId::select_same_color:
            return state.selection.set(colored_like(state.scene().spheres, state.selection.numbers()));
        case CommandId::select_hidden: return state.selection.set(hidden_ones(state.scene().spheres));
        case CommandId::go_home: return go_home(state);
        case CommandId::center_on_selection: return center_on_selection(state);
        case CommandId::fit_all: return fly_to_fit(state, axes_of(state.camera));
        case CommandId::view_front: return fly_to_fit(state, axes_from(0.0, 0.0));
        case CommandId::view_right: return fly_to_fit(state, axes_from(90.0, 0.0));
        case CommandId::view_top: return fly_to_fit(state, axes_from(0.0, 90.0));
        case CommandId::view_iso: return fly_to_fit(state, isometric_axes());
        case CommandId::use_view_as_camera:
            return perform(state, {EditScene{ChangeCamera{state.camera}, "Use of this view as the camera", 0}});
        case CommandId::next_frame: return show_frame(state, state.frame + 1);
        case CommandId::previous_frame: return show_frame(state, state.frame - 1);
        case CommandId::toggle_panel: state.panel_shown = !state.panel_shown; return;
        case CommandId::toggle_inspector: state.inspector_shown = !state.inspector_shown; return;
        case CommandId::toggle_export_area: state.export_area_shown = !state.export_area_shown; return;
        case CommandId::no_anti_aliasing:
        case CommandId::anti_aliasing_4:
        case CommandId::anti_aliasing_16: state.settings.samples = samples_of(command); return;
        case CommandId::larger_text: return scale_text(state, 1.1);
        case CommandId::smaller_text: return scale_text(state, 1.0 / 1.1);
        case CommandId::help: state.help_shown = !state.help_shown; return;
    }
}

void perform(ViewerState& state, std::vector<Action> actions) {
    for (Action& action : actions) {
        if (auto* edit = std::get_if<EditScene>(&action)) {
            apply(state, *edit);
        } else if (auto* select = std::get_if<SelectSpheres>(&action)) {
            state.selection = std::move(select->selection);
            state.selection.keep_below(state.scene().spheres.size());
        } else if (const auto* command = std::get_if<RunCommand>(&action)) {
            run_command(state, command->command);
        } else if (const auto* file = std::get_if<OpenFile>(&action)) {
            open_scene(state, file->path);
        } else if (const auto* frame = std::get_if<ShowFrame>(&action)) {
            show_frame(state, frame->frame);
        }
    }
}

}  // namespace sphereview

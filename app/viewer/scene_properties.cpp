#include "viewer/scene_properties.hpp"

#include <algorithm>
#include <utility>

#include "viewer/scene_file.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

// What is not read is no choice any more.
void forget_unread(ViewerState& state) {
    state.all_properties = false;
    std::erase_if(state.property_names,
                  [&](const std::string& name) { return find_property(state.scene().properties, name) == nullptr; });
}

}  // namespace

void note_properties(ViewerState& state, const LoadedScene& loaded) {
    state.property_names = loaded.property_names;
    state.file_order = state.document.order_revision();
}

bool has_unread_properties(const ViewerState& state) {
    return std::ranges::any_of(state.property_names,
                               [&](const std::string& name) { return find_property(state.scene().properties, name) == nullptr; });
}

std::vector<std::string> told_properties(const ViewerState& state) {
    return state.panel_shown ? state.side_panel.search.compared() : std::vector<std::string>();
}

void request_properties(ViewerState& state) {
    if (state.loading || state.saving || !has_unread_properties(state)) return;
    const auto refuse = [&state](const std::string& why) {
        forget_unread(state);
        announce(state, "The properties of the spheres cannot be read: " + why);
    };
    if (state.path.empty()) return refuse("the scene has no file");
    state.all_properties = true;
    const auto accept = [&state, refuse](LoadedScene loaded) {
        // The file's new content comes with its properties.
        if (file_states(state.path) != state.stamp) return look_at_file(state);
        const bool same =
            state.document.order_revision() == state.file_order && loaded.scene.spheres.size() == state.scene().spheres.size();
        if (!same) return refuse("spheres have come, gone or changed places since the file was read; open it again");
        state.property_names = std::move(loaded.property_names);
        state.document.add_properties(std::move(loaded.scene.properties));
        forget_unread(state);
        state.all_properties = true;
    };
    start_loading(state, {.path = state.path,
                          .options = load_options(state, state.path, state.frame),
                          .accept = accept,
                          .fail = refuse,
                          .cancel = [&state] { forget_unread(state); }});
}

}  // namespace sphereview

#include "viewer/unsaved_edits.hpp"

#include "viewer/recovery.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

std::string keep_unsaved(const ViewerState& state) {
    if (!state.document.is_changed() && !state.saving) return "";  // a save may not be finished
    const bool kept = write_recovery(state.scene(), state.path);
    return "unsaved changes of " + state.name() + (kept ? " are kept; the next start offers them" : " could not be kept");
}

std::optional<std::string> keep_unsaved_of_hung_loop(ViewerState& state, std::chrono::milliseconds limit) {
    if (!state.changing.try_lock_for(limit)) return std::nullopt;
    state.autosave.finish();  // an older copy must not replace this one
    return keep_unsaved(state);
}

}  // namespace sphereview

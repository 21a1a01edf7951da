// The file of the scene: opening, saving, reloading.
#pragma once

#include <functional>
#include <string>

#include "app/load_scene.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

// How to read that frame of the file at `path`. A scene that has a camera keeps it: of such a one only the view may be fitted.
LoadOptions load_options(const ViewerState& state, const std::string& path, std::int64_t frame);

// Takes over a scene that was read from `path` ("-" and "" have no file).
void adopt(ViewerState& state, LoadedScene loaded, const std::string& path);

// Calls `then` at once when nothing would be lost, or as soon as the person has saved it or says that it may be, and what is
// being saved is whole. `question`: instead of the usual words.
void with_edits_safe(ViewerState& state, std::function<void()> then, const std::string& question = "");

// What to do with a scene that is asked for now: `then`, and before that the question about edits, if any are made meanwhile.
std::function<void(LoadedScene)> unless_edited(ViewerState& state, std::function<void(LoadedScene)> then);

// Each asks what there is to ask, in dialogs, before anything is lost.
void new_scene(ViewerState& state);
void open_scene(ViewerState& state, const std::string& path);
void ask_for_scene(ViewerState& state);
// A dialog that begins where the scene's files are, with the folders of the recent ones to choose from.
FileBrowser file_dialog(const ViewerState& state);
void save_scene(
    ViewerState& state, const std::function<void()>& then = [] {});
void save_scene_as(
    ViewerState& state, const std::function<void()>& then = [] {});
void quit(ViewerState& state);

// The document becomes another frame of its file, which was as `stamp` says.
void adopt_frame(ViewerState& state, std::int64_t frame, LoadedScene loaded, const FileStates& stamp);

// Reads the file again if it is not as the program left it. A broken file leaves the scene as it is, and says so, and so does one
// that is gone; edits that are not saved are lost only if the person says so.
void look_at_file(ViewerState& state);

}  // namespace sphereview

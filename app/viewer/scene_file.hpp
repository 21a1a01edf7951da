// The file of the scene: opening and reloading. Saving: viewer/scene_saving.hpp.
#pragma once

#include <string>
#include <vector>

#include "app/load_scene.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

// How to read that frame of the file at `path`. A scene that has a camera keeps it: of such a one only the view may be fitted.
LoadOptions load_options(const ViewerState& state, const std::string& path, std::int64_t frame);

// Takes over a scene that was read from `path` ("-" and "" have no file).
void adopt(ViewerState& state, LoadedScene loaded, const std::string& path);

// Each asks what there is to ask, in dialogs, before anything is lost.
void new_scene(ViewerState& state);
void open_scene(ViewerState& state, const std::string& path);
void ask_for_scene(ViewerState& state);
// A dialog that begins where the scene's files are, with the folders of the recent ones to choose from.
FileBrowser file_dialog(const ViewerState& state);
// The same to save: at first at `path`, with what went wrong with it.
FileBrowser saving_dialog(const ViewerState& state, const std::string& title, const std::string& path,
                          const std::string& fault = "");
// The formats that are `wanted`, as such a dialog offers them.
std::vector<FileKind> kinds_of(bool (*wanted)(const SceneFormat&));

// The document becomes another frame of its file, which was as `stamp` says. `first` is to be said before what the reader says.
void adopt_frame(ViewerState& state, std::int64_t frame, LoadedScene loaded, const FileStates& stamp,
                 const std::string& first = "");

// Reads the file again if it is not as the program left it. A broken file leaves the scene as it is, and says so, and so does one
// that is gone; edits that are not saved are lost only if the person says so.
void look_at_file(ViewerState& state);

// The file is as it should be: nothing more is said of it.
void forget_file_messages(ViewerState& state);

}  // namespace sphereview

// The file of the scene: opening and reloading. Saving: viewer/scene_saving.hpp.
#pragma once

#include <string>
#include <vector>

#include "app/load_scene.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

// Options for reading that frame of the file at `path`. A scene with a camera keeps it.
LoadOptions load_options(const ViewerState& state, const std::string& path, std::int64_t frame);

// Takes over a scene that was read from `path` ("-" and "" have no file).
void adopt(ViewerState& state, LoadedScene loaded, const std::string& path);

// Each asks in dialogs before anything is lost.
void new_scene(ViewerState& state);
void open_scene(ViewerState& state, const std::string& path);
void ask_for_scene(ViewerState& state);
// A dialog that begins in the scene's folder, and offers the folders of recent files.
FileBrowser file_dialog(const ViewerState& state);
// The same for saving; begins with `path` and the fault of an earlier try.
FileBrowser saving_dialog(const ViewerState& state, const std::string& title, const std::string& path,
                          const std::string& fault = "");
// The `wanted` formats for such a dialog.
std::vector<FileKind> kinds_of(bool (*wanted)(const SceneFormat&));

// The document becomes another frame of its file. `stamp`: the file's when it was read. `first`: a message before the reader's.
void adopt_frame(ViewerState& state, std::int64_t frame, LoadedScene loaded, const FileStates& stamp,
                 const std::string& first = "");

// Reads the file again if it has changed on disk. A broken or missing file is reported and leaves the scene as it is. Asks before
// unsaved edits would be lost.
void look_at_file(ViewerState& state);

// Removes messages about the file, which is all right again.
void forget_file_messages(ViewerState& state);

}  // namespace sphereview

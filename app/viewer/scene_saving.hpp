// Saves the scene, and asks before unsaved changes would be lost.
#pragma once

#include <functional>
#include <string>

#include "app/load_scene.hpp"
#include "panels/dialogs.hpp"

namespace sphereview {

struct ViewerState;

// Asks a question. It replaces a waiting question with the same id.
void ask(ViewerState& state, Question question);

// Calls `then` at once if nothing would be lost; else when the person has saved the edits or gives them up, and no save is under
// way. `question`: replaces the usual words.
void with_edits_safe(ViewerState& state, std::function<void()> then, const std::string& question = "");

// `then`, for a scene that is being read, preceded by a question if edits are made meanwhile.
std::function<void(LoadedScene)> unless_edited(ViewerState& state, std::function<void(LoadedScene)> then);

// Each asks in dialogs before anything is lost.
void save_scene(
    ViewerState& state, const std::function<void()>& then = [] {});
void save_scene_as(
    ViewerState& state, const std::function<void()>& then = [] {});
void quit(ViewerState& state);

}  // namespace sphereview

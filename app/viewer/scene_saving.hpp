// Saving the scene, and what is asked before changes that are not saved would be lost.
#pragma once

#include <functional>
#include <string>

#include "app/load_scene.hpp"
#include "panels/dialogs.hpp"

namespace sphereview {

struct ViewerState;

// Asks. A question of its kind that waits already is asked for the latest purpose instead of twice.
void ask(ViewerState& state, Question question);

// Calls `then` at once when nothing would be lost, or as soon as the person has saved it or says that it may be, and what is
// being saved is whole. `question`: instead of the usual words.
void with_edits_safe(ViewerState& state, std::function<void()> then, const std::string& question = "");

// What to do with a scene that is asked for now: `then`, and before that the question about edits, if any are made meanwhile.
std::function<void(LoadedScene)> unless_edited(ViewerState& state, std::function<void(LoadedScene)> then);

// Each asks what there is to ask, in dialogs, before anything is lost.
void save_scene(
    ViewerState& state, const std::function<void()>& then = [] {});
void save_scene_as(
    ViewerState& state, const std::function<void()>& then = [] {});
void quit(ViewerState& state);

}  // namespace sphereview

// Carries out what panels, keys and the mouse ask for.
#pragma once

#include <vector>

#include "viewer/viewer_state.hpp"

namespace sphereview {

void perform(ViewerState& state, std::vector<Action> actions);

// Applies an edit, and its consequences for selection and view.
void apply(ViewerState& state, EditScene action);

// If the view shows the scene's camera, it follows changes of that camera that were made through the view.
void undo(ViewerState& state);
void redo(ViewerState& state);

// Does nothing where the command is not enabled.
void run_command(ViewerState& state, CommandId command);

// Every command as it is now, in the order of the menus.
std::vector<CommandInfo> commands_of(const ViewerState& state);

}  // namespace sphereview

// Doing what panels, keys, menus and the mouse ask for.
#pragma once

#include <vector>

#include "viewer/viewer_state.hpp"

namespace sphereview {

void perform(ViewerState& state, std::vector<Action> actions);

// An edit, with what it does to the selection and to the view.
void apply(ViewerState& state, EditScene action);

// A view that shows the scene's camera goes along where that was edited as a view.
void undo(ViewerState& state);
void redo(ViewerState& state);

// Does nothing where the command is not enabled.
void run_command(ViewerState& state, CommandId command);

// Every command as it is now, in the order of the menus.
std::vector<CommandInfo> commands_of(const ViewerState& state);

}  // namespace sphereview

// Doing what panels, keys and the mouse ask for.
#pragma once

#include <vector>

#include "viewer/viewer_state.hpp"

namespace sphereview {

void perform(ViewerState& state, std::vector<Action> actions);

void run_command(ViewerState& state, CommandId command);

// Every command as it is now, in the order of the menus.
std::vector<CommandInfo> commands_of(const ViewerState& state);

}  // namespace sphereview

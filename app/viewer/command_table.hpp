// Every command of the menus.
#pragma once

#include <vector>

#include "viewer/viewer_state.hpp"

namespace sphereview {

// Does nothing where the command is not enabled.
void run_command(ViewerState& state, CommandId command);

// Every command as it is now, in the order of the menus.
std::vector<CommandInfo> commands_of(const ViewerState& state);

}  // namespace sphereview

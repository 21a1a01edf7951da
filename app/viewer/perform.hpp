// Doing what panels, keys and the mouse ask for.
#pragma once

#include <vector>

#include "viewer/viewer_state.hpp"

namespace sphereview {

void perform(ViewerState& state, std::vector<Action> actions);

void run_command(ViewerState& state, CommandId command);

// Whether its menu item shows a check mark.
bool is_checked(const ViewerState& state, CommandId command);

// Whether the command has something to do now.
bool is_enabled(const ViewerState& state, CommandId command);

}  // namespace sphereview

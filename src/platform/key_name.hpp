// Keys as people call them.
#pragma once

#include <string>

namespace sphereview {

// What the person's keyboard layout has on a key of GLFW's, as platform/window.hpp spells it; "" for keys without a use here.
// Modifiers are "shift", "control" (Command on macOS) and "alt".
std::string key_name(int key, int scancode);

}  // namespace sphereview

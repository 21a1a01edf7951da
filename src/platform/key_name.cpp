#include "platform/key_name.hpp"

#include <array>
#include <utility>

#include "platform/glfw.hpp"

namespace sphereview {

namespace {

constexpr std::array<std::pair<int, const char*>, 24> named_keys = {{
    {GLFW_KEY_SPACE, "space"},
    {GLFW_KEY_ESCAPE, "escape"},
    {GLFW_KEY_ENTER, "enter"},
    {GLFW_KEY_KP_ENTER, "enter"},
    {GLFW_KEY_TAB, "tab"},
    {GLFW_KEY_BACKSPACE, "backspace"},
    {GLFW_KEY_INSERT, "insert"},
    {GLFW_KEY_DELETE, "delete"},
    {GLFW_KEY_RIGHT, "right"},
    {GLFW_KEY_LEFT, "left"},
    {GLFW_KEY_DOWN, "down"},
    {GLFW_KEY_UP, "up"},
    {GLFW_KEY_PAGE_UP, "page up"},
    {GLFW_KEY_PAGE_DOWN, "page down"},
    {GLFW_KEY_HOME, "home"},
    {GLFW_KEY_END, "end"},
    {GLFW_KEY_LEFT_SHIFT, "shift"},
    {GLFW_KEY_RIGHT_SHIFT, "shift"},
    {GLFW_KEY_LEFT_ALT, "alt"},
    {GLFW_KEY_RIGHT_ALT, "alt"},
#ifdef __APPLE__
    {GLFW_KEY_LEFT_SUPER, "control"},
    {GLFW_KEY_RIGHT_SUPER, "control"},
#else
    {GLFW_KEY_LEFT_CONTROL, "control"},
    {GLFW_KEY_RIGHT_CONTROL, "control"},
#endif
    {GLFW_KEY_KP_ADD, "+"},
    {GLFW_KEY_KP_SUBTRACT, "-"},
}};

}  // namespace

std::string key_name(int key, int scancode) {
    for (const auto& [code, name] : named_keys) {
        if (code == key) return name;
    }
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25) return "f" + std::to_string(key - GLFW_KEY_F1 + 1);
    const char* name = glfw().GetKeyName(key, scancode);
    // A layout without Latin letters still has its shortcuts where an English one has them.
    const bool latin = name != nullptr && name[0] > ' ' && name[0] <= '~';
    if (latin) return name;
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return {static_cast<char>('a' + key - GLFW_KEY_A)};
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return {static_cast<char>('0' + key - GLFW_KEY_0)};
    return name != nullptr ? name : "";
}

}  // namespace sphereview

#include "platform/window.hpp"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "base/error.hpp"
#include "platform/dynamic_library.hpp"
#include "platform/glfw.hpp"

namespace sphereview {

struct Window::State {
    GLFWwindow* window = nullptr;
    std::vector<InputEvent> events;
    std::array<GLFWcursor*, 6> cursors{};
    PointerShape shape = PointerShape::arrow;
    std::string title;
};

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

// What the person's keyboard layout has on a key, as platform/window.hpp spells it; "" for keys without a use here.
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

Modifiers modifiers_of(int mods) {
#ifdef __APPLE__
    constexpr int control = GLFW_MOD_SUPER;
#else
    constexpr int control = GLFW_MOD_CONTROL;
#endif
    return {(mods & control) != 0, (mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_ALT) != 0};
}

// GLFW's wheel callback does not tell.
Modifiers modifiers_now(GLFWwindow* window) {
    const auto held = [&](int left, int right) {
        return glfw().GetKey(window, left) == GLFW_PRESS || glfw().GetKey(window, right) == GLFW_PRESS;
    };
#ifdef __APPLE__
    const bool control = held(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
#else
    const bool control = held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
#endif
    return {control, held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT), held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
}

std::vector<InputEvent>& events_of(GLFWwindow* window) {
    return *static_cast<std::vector<InputEvent>*>(glfw().GetWindowUserPointer(window));
}

void on_button(GLFWwindow* window, int button, int action, int mods) {
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    const MouseButton which = button == GLFW_MOUSE_BUTTON_LEFT    ? MouseButton::left
                              : button == GLFW_MOUSE_BUTTON_RIGHT ? MouseButton::right
                                                                  : MouseButton::middle;
    events_of(window).push_back(ButtonChanged{which, action == GLFW_PRESS, modifiers_of(mods)});
}

void on_key(GLFWwindow* window, int key, int scancode, int action, int mods) {
    const std::string name = key_name(key, scancode);
    if (name.empty()) return;
    const bool pressed = action != GLFW_RELEASE;
    Modifiers modifiers = modifiers_of(mods);
    // Whether a modifier's own event counts it as held is for each system to choose.
    if (name == "control") modifiers.control = pressed;
    if (name == "shift") modifiers.shift = pressed;
    if (name == "alt") modifiers.alt = pressed;
    events_of(window).push_back(KeyChanged{name, pressed, action == GLFW_REPEAT, modifiers});
}

void on_drop(GLFWwindow* window, int count, const char** paths) {
    events_of(window).push_back(FilesDropped{{paths, paths + count}});
}

void listen(GLFWwindow* window, std::vector<InputEvent>& events) {
    glfw().SetWindowUserPointer(window, &events);
    glfw().SetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { events_of(w).push_back(PointerMoved{x, y}); });
    glfw().SetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
        if (entered == GLFW_FALSE) events_of(w).push_back(PointerLeft{});
    });
    glfw().SetMouseButtonCallback(window, on_button);
    glfw().SetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        events_of(w).push_back(WheelTurned{x, y, modifiers_now(w)});
    });
    glfw().SetKeyCallback(window, on_key);
    glfw().SetCharCallback(window, [](GLFWwindow* w, unsigned character) {
        events_of(w).push_back(CharacterTyped{static_cast<char32_t>(character)});
    });
    glfw().SetDropCallback(window, on_drop);
    glfw().SetWindowCloseCallback(window, [](GLFWwindow* w) {
        glfw().SetWindowShouldClose(w, GLFW_FALSE);  // whether it closes is for the program to say
        events_of(w).push_back(CloseRequested{});
    });
    glfw().SetWindowFocusCallback(window,
                                  [](GLFWwindow* w, int focused) { events_of(w).push_back(FocusChanged{focused == GLFW_TRUE}); });
    glfw().SetWindowRefreshCallback(window, [](GLFWwindow* w) { events_of(w).push_back(WindowChanged{}); });
    glfw().SetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { events_of(w).push_back(WindowChanged{}); });
    glfw().SetWindowContentScaleCallback(window, [](GLFWwindow* w, float, float) { events_of(w).push_back(WindowChanged{}); });
}

// What of a screen windows may cover.
struct WorkArea {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    explicit WorkArea(GLFWmonitor* monitor) { glfw().GetMonitorWorkarea(monitor, &x, &y, &width, &height); }
};

// Whether the window's title bar is: the screen that it was on may be gone.
bool is_on_a_screen(const WindowPlace& place) {
    int count = 0;
    GLFWmonitor** monitors = glfw().GetMonitors(&count);
    return std::any_of(monitors, monitors + count, [&](GLFWmonitor* monitor) {
        const WorkArea area(monitor);
        return *place.x + place.width > area.x + 50 && *place.x < area.x + area.width - 50 && *place.y >= area.y &&
               *place.y < area.y + area.height - 50;
    });
}

// The wanted size times the screen's scale, and no larger than the screen.
WindowPlace fitting(WindowPlace place) {
    GLFWmonitor* monitor = glfw().GetPrimaryMonitor();
    if (monitor == nullptr) return place;
#ifndef __APPLE__    // where a window's size is in screen coordinates anyway
    if (!place.x) {  // the window's first time
        float scale = 1.0F;
        glfw().GetMonitorContentScale(monitor, &scale, nullptr);
        place.width = static_cast<int>(static_cast<float>(place.width) * std::max(scale, 1.0F));
        place.height = static_cast<int>(static_cast<float>(place.height) * std::max(scale, 1.0F));
    }
#endif
    const WorkArea area(monitor);
    if (area.width > 0) place.width = std::min(place.width, area.width);
    if (area.height > 0) place.height = std::min(place.height, area.height);
    return place;
}

void (*connection_lost)() = nullptr;

int on_io_error(void* /*display*/) {
    connection_lost();
    return 0;
}

}  // namespace

Window::Window(const std::string& title, const WindowPlace& place) : state_(std::make_unique<State>()) {
#if defined(GLFW_PLATFORM) && !defined(_WIN32) && !defined(__APPLE__)
    // Without this folder there is no Wayland, whose library says so on stderr when GLFW 3.4 tries it first.
    const char* run_time_folder = std::getenv("XDG_RUNTIME_DIR");
    if (run_time_folder == nullptr || *run_time_folder == '\0') glfw().InitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
    if (glfw().Init() == GLFW_FALSE) throw RenderError("there is no display to open a window on: " + last_glfw_error());
    hint_at_context();
    glfw().WindowHint(GLFW_MAXIMIZED, place.maximized ? GLFW_TRUE : GLFW_FALSE);
    glfw().WindowHintString(GLFW_X11_CLASS_NAME, "sphereview");
    glfw().WindowHintString(GLFW_X11_INSTANCE_NAME, "sphereview");
    const WindowPlace fitted = fitting(place);
    state_->window = glfw().CreateWindow(fitted.width, fitted.height, title.c_str(), nullptr, nullptr);
    if (state_->window == nullptr) {
        const std::string why = last_glfw_error();
        glfw().Terminate();
        throw RenderError("no window with OpenGL 3.3 can be opened: " + why);
    }
    state_->title = title;
    if (place.x && place.y && is_on_a_screen(place)) glfw().SetWindowPos(state_->window, *place.x, *place.y);
    glfw().MakeContextCurrent(state_->window);
    if (gladLoadGL(glfw().GetProcAddress) == 0 || !GLAD_GL_VERSION_3_3) {
        glfw().DestroyWindow(state_->window);
        glfw().Terminate();
        throw RenderError("the window's context has no OpenGL 3.3 functions");
    }
    glfw().SwapInterval(1);
    listen(state_->window, state_->events);
}

Window::~Window() {
    for (GLFWcursor* cursor : state_->cursors) {
        if (cursor != nullptr) glfw().DestroyCursor(cursor);
    }
    glfw().DestroyWindow(state_->window);
    glfw().Terminate();
}

void Window::show() {
    glfw().ShowWindow(state_->window);
    glfw().FocusWindow(state_->window);
}

std::vector<InputEvent> Window::wait_events(std::optional<double> seconds) {
    // GLFW may have called back before, while another of its functions ran.
    if (!state_->events.empty() || (seconds && *seconds <= 0.0)) {
        glfw().PollEvents();
    } else if (seconds) {
        glfw().WaitEventsTimeout(*seconds);
    } else {
        glfw().WaitEvents();
    }
    return std::exchange(state_->events, {});
}

void Window::wake() { glfw().PostEmptyEvent(); }

void Window::swap_buffers() { glfw().SwapBuffers(state_->window); }

Window::Extent Window::extent() const {
    Extent extent;
    glfw().GetWindowSize(state_->window, &extent.width, &extent.height);
    return extent;
}

Window::Extent Window::framebuffer() const {
    if (glfw().GetWindowAttrib(state_->window, GLFW_ICONIFIED) == GLFW_TRUE) return {};
    Extent extent;
    glfw().GetFramebufferSize(state_->window, &extent.width, &extent.height);
    return extent;
}

double Window::content_scale() const {
    float x = 1.0F;
    float y = 1.0F;
    glfw().GetWindowContentScale(state_->window, &x, &y);
    return std::clamp(static_cast<double>(x), 1.0, 4.0);
}

WindowPlace Window::place() const {
    WindowPlace place;
    int x = 0;
    int y = 0;
    glfw().GetWindowPos(state_->window, &x, &y);
    place.x = x;
    place.y = y;
    place.width = extent().width;
    place.height = extent().height;
    place.maximized = glfw().GetWindowAttrib(state_->window, GLFW_MAXIMIZED) == GLFW_TRUE;
    return place;
}

void Window::set_title(const std::string& title) {
    if (title == state_->title) return;
    state_->title = title;
    glfw().SetWindowTitle(state_->window, title.c_str());
}

void Window::set_icon(std::vector<Icon> sizes) {
    std::vector<GLFWimage> images;
    for (Icon& icon : sizes) images.push_back({icon.side, icon.side, icon.bytes.data()});
    glfw().SetWindowIcon(state_->window, static_cast<int>(images.size()), images.data());
}

void Window::set_pointer(PointerShape shape) {
    if (shape == state_->shape) return;
    state_->shape = shape;
    constexpr std::array<int, 6> shapes = {GLFW_ARROW_CURSOR,   GLFW_IBEAM_CURSOR, GLFW_HRESIZE_CURSOR,
                                           GLFW_VRESIZE_CURSOR, GLFW_HAND_CURSOR,  GLFW_CROSSHAIR_CURSOR};
    const auto index = static_cast<std::size_t>(shape);
    if (state_->cursors[index] == nullptr) state_->cursors[index] = glfw().CreateStandardCursor(shapes[index]);
    glfw().SetCursor(state_->window, state_->cursors[index]);
}

std::string Window::clipboard() const {
    const char* text = glfw().GetClipboardString(state_->window);
    return text != nullptr ? text : "";
}

void Window::set_clipboard(const std::string& text) { glfw().SetClipboardString(state_->window, text.c_str()); }

void Window::set_connection_lost_handler(void (*on_loss)()) {
    static const DynamicLibrary xlib({"libX11.so.6"});  // the one that GLFW uses: no second is loaded
    using SetHandler = int (*(*)(int (*)(void*)))(void*);
    const auto set_handler = reinterpret_cast<SetHandler>(xlib.find("XSetIOErrorHandler"));
    if (set_handler == nullptr) return;
    connection_lost = on_loss;
    set_handler(on_io_error);
}

}  // namespace sphereview

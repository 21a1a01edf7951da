// A window with an OpenGL 3.3 core context, and its input.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "platform/gl_context.hpp"

namespace sphereview {

struct Modifiers {
    bool control = false;  // Command on macOS
    bool shift = false;
    bool alt = false;

    bool operator==(const Modifiers&) const = default;
};

enum class MouseButton { left, right, middle };

// What a person or the system did, in the order in which it happened. Places are in screen coordinates of the window,
// (0, 0) at the top left; times framebuffer() / extent() they are pixels.
struct PointerMoved {
    double x = 0.0;
    double y = 0.0;
};
struct PointerLeft {};
struct ButtonChanged {
    MouseButton button = MouseButton::left;
    bool pressed = false;
    Modifiers modifiers;
};
struct WheelTurned {
    double x = 0.0;
    double y = 0.0;  // > 0: away from the person
    Modifiers modifiers;
};
// A key by what the person's keyboard layout has there ("a", "7", "+") or by its usual name in lower case ("f12", "delete",
// "backspace", "enter", "escape", "tab", "space", "home", "end", "page up", "page down", "insert", "left", "right", "up", "down",
// "shift", "control", "alt").
struct KeyChanged {
    std::string name;
    bool pressed = false;
    bool repeated = false;
    Modifiers modifiers;
};
struct CharacterTyped {
    char32_t character = 0;
};
struct FilesDropped {
    std::vector<std::string> paths;
};
struct CloseRequested {};
struct FocusChanged {
    bool focused = false;
};
// The window was resized, uncovered, or moved to a screen of another scale: it must be drawn again.
struct WindowChanged {};

using InputEvent = std::variant<PointerMoved, PointerLeft, ButtonChanged, WheelTurned, KeyChanged, CharacterTyped, FilesDropped,
                                CloseRequested, FocusChanged, WindowChanged>;

enum class PointerShape { arrow, text, horizontal_resize, vertical_resize, hand, cross };

// Where a window is, in screen coordinates. No place: the system chooses.
struct WindowPlace {
    std::optional<int> x;
    std::optional<int> y;
    int width = 1400;
    int height = 1000;
    bool maximized = false;

    bool operator==(const WindowPlace&) const = default;
};

// The one window of the program. Not shown until show().
class Window : public GlContext {
public:
    // Throws RenderError when there is no display or no OpenGL 3.3.
    Window(const std::string& title, const WindowPlace& place);
    ~Window() override;

    void show();

    // Waits until something happens, wake() is called or so many seconds have passed (nothing: for ever), and returns all
    // that has happened since the last call.
    std::vector<InputEvent> wait_events(std::optional<double> seconds);

    // Makes wait_events() return. From any thread.
    static void wake();

    void swap_buffers();

    struct Extent {
        int width = 0;
        int height = 0;
    };
    Extent extent() const;         // in screen coordinates
    Extent framebuffer() const;    // in pixels; 0 x 0 when minimised
    double content_scale() const;  // how much larger than usual the system wants text, 1 or more
    WindowPlace place() const;

    void set_title(const std::string& title);
    // A square of RGBA bytes, the top row first, in several sizes. Systems that take icons from elsewhere ignore it.
    struct Icon {
        int side = 0;
        std::vector<unsigned char> bytes;
    };
    void set_icon(std::vector<Icon> sizes);
    void set_pointer(PointerShape shape);
    std::string clipboard() const;
    void set_clipboard(const std::string& text);

    // `on_loss` is called when the connection to the X server breaks; Xlib ends the process when it returns. It must not use the
    // window. Does nothing where there is no Xlib.
    static void set_connection_lost_handler(void (*on_loss)());

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace sphereview

// A connection to an X server, and the program's window there.
#pragma once

#include <X11/Xlib.h>

#include <stdexcept>
#include <string>

namespace sphereview::test {

class XConnection {
public:
    explicit XConnection(const std::string& name) : display_(XOpenDisplay(name.c_str())) {
        if (display_ == nullptr) throw std::runtime_error("no connection to the X server " + name);
    }
    ~XConnection() { XCloseDisplay(display_); }
    XConnection(const XConnection&) = delete;
    XConnection& operator=(const XConnection&) = delete;

    Display* get() const { return display_; }
    Window root() const { return DefaultRootWindow(display_); }
    Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

    // The program's window: the one that is shown and has a close button. Throws when there is none.
    Window program_window() const;

private:
    Display* display_;
};

}  // namespace sphereview::test

#include "ui/x_server.hpp"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <poll.h>

#include <chrono>
#include <csignal>
#include <stdexcept>

namespace sphereview::test {

namespace {

// A connection to an X server, and the program's window there.
class Connection {
public:
    explicit Connection(const std::string& name) : display_(XOpenDisplay(name.c_str())) {
        if (display_ == nullptr) throw std::runtime_error("no connection to the X server " + name);
    }
    ~Connection() { XCloseDisplay(display_); }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    Display* get() const { return display_; }
    Window root() const { return DefaultRootWindow(display_); }
    long atom(const char* name) const { return static_cast<long>(XInternAtom(display_, name, False)); }

    // The one that is shown and has a close button. Throws when there is none.
    Window program_window() const {
        Window root_return = 0;
        Window parent = 0;
        Window* children = nullptr;
        unsigned count = 0;
        XQueryTree(display_, root(), &root_return, &parent, &children, &count);
        Window found = 0;
        for (unsigned i = 0; i < count; ++i) {
            XWindowAttributes attributes{};
            Atom* protocols = nullptr;
            int protocol_count = 0;
            if (XGetWindowAttributes(display_, children[i], &attributes) == 0 || attributes.map_state != IsViewable) continue;
            if (XGetWMProtocols(display_, children[i], &protocols, &protocol_count) == 0) continue;
            XFree(protocols);
            found = children[i];
        }
        if (children != nullptr) XFree(children);
        if (found == 0) throw std::runtime_error("no window of the program is shown");
        return found;
    }

    void send(Window target, const char* type, const std::vector<long>& values) const {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target;
        event.xclient.message_type = static_cast<Atom>(atom(type));
        event.xclient.format = 32;
        for (std::size_t i = 0; i < values.size(); ++i) event.xclient.data.l[i] = values[i];
        XSendEvent(display_, target, False, NoEventMask, &event);
        XFlush(display_);
    }

private:
    Display* display_;
};

std::string uri_list(const std::vector<std::string>& paths) {
    std::string list;
    for (const std::string& path : paths) {
        list += "file://";
        for (const char c : path) {
            constexpr const char* digits = "0123456789ABCDEF";
            const auto byte = static_cast<unsigned char>(c);
            if (c == '/') {
                list += c;
            } else {
                list += {'%', digits[byte / 16], digits[byte % 16]};
            }
        }
        list += "\r\n";
    }
    return list;
}

// The source's side of a drop: https://www.freedesktop.org/wiki/Specifications/XDND/
class Source {
public:
    Source(const std::string& display, std::string data)
        : x_(display), data_(std::move(data)), window_(XCreateSimpleWindow(x_.get(), x_.root(), -10, -10, 1, 1, 0, 0, 0)) {
        XSetSelectionOwner(x_.get(), static_cast<Atom>(x_.atom("XdndSelection")), window_, CurrentTime);
    }

    bool drop_at(int column, int row) {
        const Window target = x_.program_window();
        const auto self = static_cast<long>(window_);
        x_.send(target, "XdndEnter", {self, 5L << 24, x_.atom("text/uri-list"), 0, 0});
        x_.send(target, "XdndPosition", {self, 0, (static_cast<long>(column) << 16) | row, CurrentTime, x_.atom("XdndActionCopy")});
        if ((wait_for("XdndStatus").data.l[1] & 1) == 0) return false;
        x_.send(target, "XdndDrop", {self, 0, CurrentTime, 0, 0});
        // GLFW 3.3 says how many bytes it took where the protocol has a 1.
        return wait_for("XdndFinished").data.l[1] != 0;
    }

private:
    void answer(const XSelectionRequestEvent& request) {
        XChangeProperty(x_.get(), request.requestor, request.property, request.target, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(data_.data()), static_cast<int>(data_.size()));
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.property = request.property;
        event.xselection.time = request.time;
        XSendEvent(x_.get(), request.requestor, False, NoEventMask, &event);
        XFlush(x_.get());
    }

    XClientMessageEvent wait_for(const char* type) {
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (std::chrono::steady_clock::now() < deadline) {
            pollfd waiting{ConnectionNumber(x_.get()), POLLIN, 0};
            if (XPending(x_.get()) == 0) poll(&waiting, 1, 100);
            while (XPending(x_.get()) > 0) {
                XEvent event{};
                XNextEvent(x_.get(), &event);
                if (event.type == SelectionRequest) answer(event.xselectionrequest);
                if (event.type == ClientMessage && event.xclient.message_type == static_cast<Atom>(x_.atom(type))) {
                    return event.xclient;
                }
            }
        }
        throw std::runtime_error(std::string("the window sends no ") + type);
    }

    Connection x_;
    std::string data_;
    Window window_;
};

}  // namespace

XServer::XServer(const ScreenOptions& options) {
    const std::string screen = std::to_string(options.width) + "x" + std::to_string(options.height) + "x24";
    // Xvfb chooses a display that is free and, once that can be used, says which on standard error.
    xvfb_ =
        std::make_unique<Running>(Command{.arguments = {"-displayfd", "2", "-screen", "0", screen, "-nolisten", "tcp", "-noreset"},
                                          .program = XVFB,
                                          .input_stays_open = true});
    // Lines before that are of displays that others have.
    std::size_t from = 0;
    for (int line_count = 1; display_.empty(); ++line_count) {
        if (!xvfb_->wait_for_errors("\n", line_count)) {
            throw std::runtime_error("Xvfb does not start: " + xvfb_->errors_so_far());
        }
        const std::string& errors = xvfb_->errors_so_far();
        const std::size_t end = errors.find('\n', from);
        const std::string line = errors.substr(from, end - from);
        from = end + 1;
        if (!line.empty() && line.find_first_not_of("0123456789") == std::string::npos) display_ = ":" + line;
    }
    const Connection x(display_);
    const std::string resources = "Xft.dpi:\t" + std::to_string(options.dpi) + "\n";
    XChangeProperty(x.get(), x.root(), XA_RESOURCE_MANAGER, XA_STRING, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(resources.data()), static_cast<int>(resources.size()));
    XSync(x.get(), False);
}

void XServer::kill() { xvfb_->send(SIGKILL); }
void XServer::hang() { xvfb_->send(SIGSTOP); }

Picture XServer::screen() const {
    const Connection x(display_);
    XWindowAttributes attributes{};
    XGetWindowAttributes(x.get(), x.root(), &attributes);
    XImage* image = XGetImage(x.get(), x.root(), 0, 0, static_cast<unsigned>(attributes.width),
                              static_cast<unsigned>(attributes.height), AllPlanes, ZPixmap);
    if (image == nullptr) throw std::runtime_error("the screen cannot be read");
    Picture picture{attributes.width, attributes.height, 3, {}};
    picture.bytes.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * 3);
    char* to = picture.bytes.data();
    for (int row = 0; row < attributes.height; ++row) {
        for (int column = 0; column < attributes.width; ++column) {
            const unsigned long pixel = XGetPixel(image, column, row);
            *to++ = static_cast<char>(pixel >> 16);
            *to++ = static_cast<char>(pixel >> 8);
            *to++ = static_cast<char>(pixel);
        }
    }
    XDestroyImage(image);
    return picture;
}

std::size_t XServer::icon_pixels() const {
    const Connection x(display_);
    Atom type = None;
    int format = 0;
    unsigned long items = 0;
    unsigned long rest = 0;
    unsigned char* data = nullptr;
    XGetWindowProperty(x.get(), x.program_window(), static_cast<Atom>(x.atom("_NET_WM_ICON")), 0, 1 << 20, False, XA_CARDINAL,
                       &type, &format, &items, &rest, &data);
    // Each has its width and height before it.
    std::size_t pixels = 0;
    const auto* values = reinterpret_cast<const long*>(data);
    for (unsigned long at = 0; at + 1 < items;) {
        const auto size = static_cast<std::size_t>(values[at]) * static_cast<std::size_t>(values[at + 1]);
        pixels += size;
        at += size + 2;
    }
    if (data != nullptr) XFree(data);
    return pixels;
}

void XServer::press_close_button() const {
    const Connection x(display_);
    x.send(x.program_window(), "WM_PROTOCOLS", {x.atom("WM_DELETE_WINDOW"), CurrentTime});
}

bool XServer::drop(const std::vector<std::string>& paths, int x, int y) const {
    return Source(display_, uri_list(paths)).drop_at(x, y);
}

}  // namespace sphereview::test

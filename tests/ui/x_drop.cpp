// The source's side of a drop: https://www.freedesktop.org/wiki/Specifications/XDND/
#include <poll.h>

#include <chrono>

#include "ui/x_client.hpp"
#include "ui/x_connection.hpp"

namespace sphereview::test {

namespace {

constexpr auto patience = std::chrono::seconds(60);

std::string uri_list(const std::vector<std::string>& paths) {
    std::string list;
    for (const std::string& path : paths) {
        list += "file://";
        for (const char c : path) {
            const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '/' || c == '.' ||
                               c == '-' || c == '_';
            constexpr const char* digits = "0123456789ABCDEF";
            const auto byte = static_cast<unsigned char>(c);
            if (plain) {
                list += c;
            } else {
                list += {'%', digits[byte / 16], digits[byte % 16]};
            }
        }
        list += "\r\n";
    }
    return list;
}

class Source {
public:
    Source(const std::string& display, std::string data) : x_(display), data_(std::move(data)) {
        window_ = XCreateSimpleWindow(x_.get(), x_.root(), -10, -10, 1, 1, 0, 0, 0);
        target_ = x_.program_window();
        XSetSelectionOwner(x_.get(), x_.atom("XdndSelection"), window_, CurrentTime);
    }

    bool drop_at(int column, int row) {
        send("XdndEnter", {5L << 24, atom_number("text/uri-list"), 0, 0});
        send("XdndPosition", {0, (static_cast<long>(column) << 16) | row, CurrentTime, atom_number("XdndActionCopy")});
        const XClientMessageEvent status = wait_for("XdndStatus");
        if ((status.data.l[1] & 1) == 0) return false;
        send("XdndDrop", {0, CurrentTime, 0, 0});
        // GLFW 3.3 says how many bytes it took where the protocol has a 1.
        return wait_for("XdndFinished").data.l[1] != 0;
    }

private:
    long atom_number(const char* name) const { return static_cast<long>(x_.atom(name)); }

    void send(const char* type, const std::vector<long>& values) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target_;
        event.xclient.message_type = x_.atom(type);
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(window_);
        for (std::size_t i = 0; i < values.size(); ++i) event.xclient.data.l[i + 1] = values[i];
        XSendEvent(x_.get(), target_, False, NoEventMask, &event);
        XFlush(x_.get());
    }

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
        const auto deadline = std::chrono::steady_clock::now() + patience;
        while (std::chrono::steady_clock::now() < deadline) {
            pollfd waiting{ConnectionNumber(x_.get()), POLLIN, 0};
            if (XPending(x_.get()) == 0) poll(&waiting, 1, 100);
            while (XPending(x_.get()) > 0) {
                XEvent event{};
                XNextEvent(x_.get(), &event);
                if (event.type == SelectionRequest) answer(event.xselectionrequest);
                if (event.type == ClientMessage && event.xclient.message_type == x_.atom(type)) return event.xclient;
            }
        }
        throw std::runtime_error(std::string("the window sends no ") + type);
    }

    XConnection x_;
    std::string data_;
    Window window_ = 0;
    Window target_ = 0;
};

}  // namespace

bool drop_files(const std::string& display, const std::vector<std::string>& paths, int x, int y) {
    return Source(display, uri_list(paths)).drop_at(x, y);
}

}  // namespace sphereview::test

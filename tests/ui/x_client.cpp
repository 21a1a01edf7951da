#include "ui/x_client.hpp"

#include <X11/Xatom.h>
#include <X11/Xutil.h>

#include <cstdint>

#include "ui/x_connection.hpp"

namespace sphereview::test {

Window XConnection::program_window() const {
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

void set_text_resolution(const std::string& display, int dpi) {
    const XConnection x(display);
    const std::string resources = "Xft.dpi:\t" + std::to_string(dpi) + "\n";
    XChangeProperty(x.get(), x.root(), XA_RESOURCE_MANAGER, XA_STRING, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(resources.data()), static_cast<int>(resources.size()));
    XSync(x.get(), False);
}

Picture read_screen(const std::string& display) {
    const XConnection x(display);
    XWindowAttributes attributes{};
    XGetWindowAttributes(x.get(), x.root(), &attributes);
    XImage* image = XGetImage(x.get(), x.root(), 0, 0, static_cast<unsigned>(attributes.width),
                              static_cast<unsigned>(attributes.height), AllPlanes, ZPixmap);
    if (image == nullptr) throw std::runtime_error("the screen cannot be read");
    Picture picture{attributes.width, attributes.height, 3, {}};
    for (int row = 0; row < attributes.height; ++row) {
        for (int column = 0; column < attributes.width; ++column) {
            const unsigned long pixel = XGetPixel(image, column, row);
            for (const int shift : {16, 8, 0}) picture.bytes += static_cast<char>((pixel >> shift) & 0xFFU);
        }
    }
    XDestroyImage(image);
    return picture;
}

void press_close_button(const std::string& display) {
    const XConnection x(display);
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = x.program_window();
    event.xclient.message_type = x.atom("WM_PROTOCOLS");
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(x.atom("WM_DELETE_WINDOW"));
    event.xclient.data.l[1] = CurrentTime;
    XSendEvent(x.get(), event.xclient.window, False, NoEventMask, &event);
    XFlush(x.get());
}

}  // namespace sphereview::test

#include "platform/connection_loss.hpp"

#include "platform/dynamic_library.hpp"

namespace sphereview {

namespace {

void (*connection_lost)() = nullptr;

int on_io_error(void* /*display*/) {
    connection_lost();
    return 0;
}

}  // namespace

void handle_connection_loss(void (*on_loss)()) {
    static const DynamicLibrary xlib({"libX11.so.6"});  // the one that GLFW uses: no second is loaded
    using SetHandler = int (*(*)(int (*)(void*)))(void*);
    const auto set_handler = reinterpret_cast<SetHandler>(xlib.find("XSetIOErrorHandler"));
    if (set_handler == nullptr) return;
    connection_lost = on_loss;
    set_handler(on_io_error);
}

}  // namespace sphereview

// The end of the connection to the X server.
#pragma once

namespace sphereview {

// `on_loss` is called when the connection breaks; Xlib ends the process when it returns. Does nothing where there is no Xlib.
void handle_connection_loss(void (*on_loss)());

}  // namespace sphereview

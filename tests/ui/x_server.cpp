#include "ui/x_server.hpp"

#include <csignal>
#include <stdexcept>

#include "ui/x_client.hpp"

namespace sphereview::test {

XServer::XServer(const ScreenOptions& options) {
    const std::string screen = std::to_string(options.width) + "x" + std::to_string(options.height) + "x24";
    Command command;
    command.program = XVFB;
    // It chooses a display that is free and, once it can be used, says which on standard error.
    command.arguments = {"-displayfd", "2", "-screen", "0", screen, "-nolisten", "tcp", "-noreset"};
    command.input_stays_open = true;
    xvfb_ = std::make_unique<Running>(command);
    // Lines before it are of displays that others have.
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
    set_text_resolution(display_, options.dpi);
}

void XServer::kill() { xvfb_->send(SIGKILL); }

}  // namespace sphereview::test

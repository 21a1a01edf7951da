// render never talks to X, even where there seems to be a display.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

#include "support/folders.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

// Listens where an X server would, and knows whether anybody came.
class Listener {
public:
    Listener() {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t length = sizeof address;
        auto* generic = reinterpret_cast<sockaddr*>(&address);
        if (bind(socket_, generic, length) != 0 || listen(socket_, 8) != 0 || getsockname(socket_, generic, &length) != 0) {
            ADD_FAILURE() << "no socket to listen at";
        }
        port_ = ntohs(address.sin_port);
    }
    ~Listener() { close(socket_); }
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    // X display n listens at port 6000 + n.
    std::string display() const { return "127.0.0.1:" + std::to_string(port_ - 6000); }

    bool somebody_came() const { return accept(socket_, nullptr, nullptr) >= 0 || errno != EAGAIN; }

private:
    int socket_ = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    int port_ = 0;
};

TEST(NoDisplay, IsEverOpened) {
    // A driver that is too old makes the program try everything that EGL offers.
    const std::optional<std::string> old = "3.2";
    for (const auto& [backend, gl_version, said] : {std::tuple{"auto", std::optional<std::string>(), "backend: egl"},
                                                    {"egl", std::nullopt, "backend: egl"},
                                                    {"osmesa", std::nullopt, "backend: osmesa"},
                                                    {"cpu", std::nullopt, "backend: cpu"},
                                                    {"auto", old, "backend: cpu; passed over: EGL device 0"}}) {
        const Listener x_server;
        const Outcome outcome =
            run({.arguments = {"render", "-", "-s", "5x5", "-o", "-", "--verbose", "--backend", backend},
                 .input = red_scene,
                 .environment = {
                     {"DISPLAY", x_server.display()}, {"XAUTHORITY", "/nowhere"}, {"MESA_GL_VERSION_OVERRIDE", gl_version}}});
        EXPECT_EQ(outcome.status, 0) << outcome;
        EXPECT_TRUE(contains(outcome.errors, said));
        EXPECT_EQ(decode_png(outcome.output).at(2, 2), (std::vector<int>{255, 0, 0}));
        EXPECT_FALSE(x_server.somebody_came()) << said;
    }
}

TEST(NoDisplay, ListenerNoticesAVisitor) {
    const Listener x_server;
    EXPECT_FALSE(x_server.somebody_came());
    const int visitor = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(6000 + std::stoi(x_server.display().substr(10))));
    ASSERT_EQ(connect(visitor, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    EXPECT_TRUE(x_server.somebody_came());
    close(visitor);
}

TEST(NoDisplay, LibraryIsLinked) {
    const Outcome outcome = run({.arguments = {"ldd", build_file("sphereview")}, .program = "/usr/bin/env"});
    ASSERT_EQ(outcome.status, 0) << outcome;
    EXPECT_TRUE(contains(outcome.output, "libc."));
    for (const char* library : {"libX11", "libxcb", "libwayland", "libglfw", "libEGL", "libGL.", "libOSMesa"}) {
        EXPECT_FALSE(contains(outcome.output, library));
    }
}

}  // namespace
}  // namespace sphereview::test

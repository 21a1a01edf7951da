#include "base/isolated_call.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace sphereview {
namespace {

using End = IsolatedResult::End;

IsolatedResult isolated(const std::function<std::string()>& call) { return call_isolated(call, std::chrono::minutes(5)); }

// Not by std::raise(), which a sanitizer's handler would survive to tell of.
std::string crash() {
    std::signal(SIGABRT, SIG_DFL);
    std::abort();
}

TEST(IsolatedCall, PassesOnWhatIsReturnedAndSaid) {
    const std::string large(300'000, 'x');  // more than a pipe holds
    const IsolatedResult result = isolated([&] {
        std::fputs("to the terminal", stdout);
        std::fputs("one\ntwo\n", stderr);
        return large;
    });
    EXPECT_EQ(result.end, End::returned);
    EXPECT_EQ(result.value, large);
    EXPECT_EQ(result.errors, "one\ntwo\n");
}

TEST(IsolatedCall, SaysHowElseItEnded) {
    const IsolatedResult crashed = isolated(crash);
    EXPECT_EQ(crashed.end, End::crashed);
    EXPECT_EQ(crashed.code, SIGABRT);
    const IsolatedResult ended = isolated([]() -> std::string { std::_Exit(7); });
    EXPECT_EQ(ended.end, End::exited);
    EXPECT_EQ(ended.code, 7);
    EXPECT_EQ(isolated([]() -> std::string { std::_Exit(0); }).end, End::exited);
    EXPECT_EQ(isolated([]() -> std::string { throw std::runtime_error("no"); }).end, End::exited);
}

TEST(IsolatedCall, EndsAtTheLimit) {
    const IsolatedResult result = call_isolated(
        [] {
            std::fputs("begun", stderr);
            while (true) std::this_thread::sleep_for(std::chrono::hours(1));
            return std::string();
        },
        std::chrono::milliseconds(300));
    EXPECT_EQ(result.end, End::timed_out);
    EXPECT_EQ(result.errors, "begun");
}

}  // namespace
}  // namespace sphereview

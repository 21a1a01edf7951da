// Leaks of the GPU path, which a build with AddressSanitizer reports when the program ends.
#include <gtest/gtest.h>

#include "support/folders.hpp"
#include "support/render.hpp"

namespace sphereview::test {
namespace {

TEST(Leaks, AreNotLeftByTheGpuPath) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    folder.write("blue.txt", blue_scene);
    folder.write("bad.txt", bad_scene);
    const Outcome outcome = run({.arguments = {"render", "red.txt", "bad.txt", "blue.txt", "--backend", "osmesa", "-s", "50x50"},
                                 .folder = folder.path(),
                                 .environment = {{"LSAN_OPTIONS", "suppressions=" + source_file("tests/lsan.supp")}}});
    EXPECT_EQ(outcome.status, 2) << outcome;  // the bad scene's
    EXPECT_EQ(outcome.errors.find("LeakSanitizer"), std::string::npos) << outcome;
}

}  // namespace
}  // namespace sphereview::test

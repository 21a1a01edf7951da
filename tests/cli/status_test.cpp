// The exit statuses that --help promises.
#include <gtest/gtest.h>

#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

struct Case {
    std::vector<std::string> arguments;
    int status;
};

TEST(ExitStatus, SaysWhatWentWrongAndOfSeveralTheHighestCounts) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    folder.write("blue.txt", blue_scene);
    folder.write("bad.txt", bad_scene);
    ASSERT_EQ(render(folder, {"red.txt", "-s", "5x5", "-o", "golden.png"}).status, 0);
    const std::vector<Case> cases = {
        {{"red.txt", "-o", "new.png"}, 0},
        {{"red.txt", "--expect", "golden.png"}, 0},
        {{"blue.txt", "--expect", "golden.png"}, 1},
        {{"bad.txt"}, 2},
        {{"red.txt", "--size", "none"}, 2},
        {{"red.txt", "-o", "missing/new.png"}, 4},
        {{"red.txt", "blue.txt", "--expect", "golden.png"}, 1},
        {{"blue.txt", "bad.txt", "red.txt", "--expect", "golden.png"}, 2},
        {{"bad.txt", "red.txt", "-o", "missing/{name}.png"}, 4},
        {{"blue.txt", "--expect", "golden.png", "-o", "/dev/full"}, 4},
    };
    for (const auto& [arguments, status] : cases) {
        std::vector<std::string> all = {"-s", "5x5"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Outcome outcome = render(folder, all);
        EXPECT_EQ(outcome.status, status) << testing::PrintToString(arguments) << ": " << outcome;
        EXPECT_EQ(outcome.errors.empty(), status == 0) << outcome;
    }
}

#ifndef SPHEREVIEW_SANITIZED  // AddressSanitizer reserves more address space than any sensible limit
TEST(ExitStatus, Is3WhenMemoryRunsOut) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    Command command = cpu_render(folder, {"red.txt", "-s", "20000x20000"});  // 1.2 GB of pixels
    command.most_memory = 1'000'000'000;
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 3) << outcome;
    EXPECT_EQ(outcome.errors, "red.txt: memory ran out\n");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"red.txt"});
}

TEST(ExitStatus, Is3WhenASceneCannotFitInMemory) {
    const TemporaryFolder folder;
    folder.write("big.txt", "50000000\n");
    folder.write("big.toml", "# \n");
    for (const char* name : {"big.txt", "big.toml"}) std::filesystem::resize_file(folder.path(name), 1'500'000'000);  // sparse
    for (const auto& [name, said] : {std::pair{"big.txt", "big.txt: 50,000,000 spheres need 6.5 GB of memory, "},
                                     std::pair{"big.toml", "big.toml: its bytes need 1.5 GB of memory, "}}) {
        Command command = cpu_render(folder, {name, "-s", "5x5"});
        command.most_memory = 1'000'000'000;
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 3) << outcome;
        EXPECT_TRUE(outcome.errors.starts_with(said)) << outcome;
        EXPECT_TRUE(outcome.errors.ends_with(" MB are available\n")) << outcome;
    }
}
#endif

}  // namespace
}  // namespace sphereview::test

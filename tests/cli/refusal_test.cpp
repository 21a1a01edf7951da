// Command lines that would destroy a file, refused before anything is written.
#include <gtest/gtest.h>

#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

struct Case {
    std::vector<std::string> arguments;
    std::string said;
};

class Refusal : public testing::Test {
protected:
    Refusal() {
        folder_.write("a.txt", red_scene);
        folder_.write("b.txt", blue_scene);
        folder_.write("other/a.txt", red_scene);
        folder_.write("golden.png", encode_png(plain_picture(5, 5, {0, 0, 0})));
        std::filesystem::create_symlink("a.txt", folder_.path("link-to-a.png"));
        std::filesystem::create_symlink("golden.png", folder_.path("link-to-golden.png"));
        std::filesystem::create_symlink("new.png", folder_.path("dangling.png"));
        std::filesystem::create_directory_symlink(".", folder_.path("here"));
    }

    void expect_refused(const Command& command, const std::string& said) const {
        SCOPED_TRACE(testing::PrintToString(command.arguments));
        const auto before = folder_.names();
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_EQ(outcome.output, "");
        EXPECT_EQ(lines(outcome.errors).size(), 1U) << outcome;
        EXPECT_TRUE(contains(outcome.errors, said));
        EXPECT_EQ(folder_.names(), before);
        EXPECT_EQ(folder_.read("a.txt"), red_scene);
    }

    TemporaryFolder folder_;
};

TEST_F(Refusal, OfAnOutputThatIsAnInputAGoldenOrAnotherOutput) {
    const std::vector<Case> cases = {
        {{"a.txt", "-o", "a.txt"}, "a.txt: cannot be both the picture of a.txt and the scene a.txt"},
        {{"a.txt", "-o", "./other/../a.txt"}, "cannot be both"},
        {{"a.txt", "-o", folder_.path("a.txt")}, "cannot be both"},
        {{"a.txt", "-o", "link-to-a.png"}, "link-to-a.png: cannot be both"},
        {{"a.txt", "-o", "here/a.txt"}, "cannot be both"},
        {{"here/a.txt", "-o", "a.txt"}, "cannot be both"},
        {{"b.txt", "a.txt", "-o", "{name}.txt"}, "cannot be both"},
        {{"b.txt", "a.txt", "-o", "a.txt"}, "cannot be both"},
        {{"a.txt", "--expect", "golden.png", "-o", "golden.png"},
         "golden.png: cannot be both the picture of a.txt and the expected picture"},
        {{"a.txt", "--expect", "golden.png", "-o", "link-to-golden.png"}, "cannot be both"},
        {{"a.txt", "--expect", "link-to-golden.png", "-o", "here/golden.png"}, "cannot be both"},
        {{"a.txt", "--expect", "golden.png", "--diff", "golden.png"},
         "cannot be both the difference picture of a.txt and the expected"},
        {{"a.txt", "--expect", "golden.png", "--diff", "a.txt"}, "cannot be both"},
        {{"a.txt", "--expect", "golden.png", "-o", "new.png", "--diff", "new.png"}, "new.png: cannot be both"},
        {{"a.txt", "--expect", "golden.png", "-o", "new.png", "--diff", "here/dangling.png"}, "cannot be both"},
        {{"a.txt", "b.txt", "-o", "new.png"}, "new.png: cannot be both the picture of b.txt and the picture of a.txt; use {name}"},
        {{"a.txt", "other/a.txt"}, "a.png: cannot be both"},
        {{"a.txt", "other/a.txt", "-o", "{name}.png"}, "; both scenes are called 'a': render them one at a time"},
        {{"a.txt", "a.txt"}, "; both scenes are called 'a': render them one at a time"},
        {{"a.txt", "--expect", "golden.png", "-o", "{name}.png", "--diff", "{name}.png"}, "; they need two names"},
        {{"a.txt", "ba.txt", "--expect", "golden.png", "-o", "b{name}.png", "--diff", "{name}.png"}, "; choose another pattern"},
        {{"a.txt", "b.txt", "--expect", "golden.png", "--diff", "d.png"}, "d.png: cannot be both"},
        {{"a.txt", "b.txt", "-o", "-"}, "stdout cannot be both"},
        {{"a.txt", "-o", "-", "--json"}, "stdout cannot be both the JSON report and the picture of a.txt"},
        {{"a.txt", "--expect", "golden.png", "-o", "-", "--diff", "-"}, "stdout cannot be both"},
        {{"-", "-"}, "stdin cannot be both"},
        {{"-", "--expect", "-"}, "stdin cannot be both"},
    };
    for (const auto& [arguments, said] : cases) expect_refused(cpu_render(folder_, arguments), said);
}

TEST_F(Refusal, OfConvertingAFileIntoItself) {
    std::filesystem::create_symlink("a.txt", folder_.path("link.toml"));
    for (const char* output : {"a.txt", "./a.txt", "here/a.txt", "link.toml"}) {
        Command command;
        command.arguments = {"convert", "a.txt", output, "--to", "toml"};
        command.folder = folder_.path();
        expect_refused(command, std::string(output) + ": the output is also the input");
    }
}

TEST_F(Refusal, DoesNotConcernDevicesAndRepeatedReading) {
    const std::vector<std::vector<std::string>> cases = {
        {"a.txt", "b.txt", "-o", "/dev/null"},
        {"a.txt", "a.txt", "-o", "/dev/null"},
        {"/dev/stdin", "-o", "/dev/null"},
    };
    for (const auto& arguments : cases) {
        Command command = cpu_render(folder_, arguments);
        command.arguments.insert(command.arguments.end(), {"-s", "5x5"});
        command.input = red_scene;
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 0) << outcome;
    }
    // One golden for two scenes is read twice.
    EXPECT_EQ(render(folder_, {"a.txt", "other/a.txt", "-s", "5x5", "--expect", "golden.png"}).status, 1);
}

}  // namespace
}  // namespace sphereview::test

// Shaders that are wrong: what their log says, and that a layout which C++ does not share is noticed.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.hpp"
#include "gl/contexts.hpp"
#include "gpu/program.hpp"
#include "support/folders.hpp"
#include "support/text_match.hpp"

namespace sphereview {

namespace {

std::map<std::string, std::string>& shader_texts() {
    static std::map<std::string, std::string> texts;
    return texts;
}

std::map<std::string, std::string_view, std::less<>>& shaders() {
    static std::map<std::string, std::string_view, std::less<>> views;
    return views;
}

}  // namespace

// In place of the one that the build makes of shaders/.
const std::map<std::string, std::string_view, std::less<>>& embedded_shaders() { return shaders(); }

namespace test {
namespace {

class ShaderTest : public testing::Test {
protected:
    ShaderTest() {
        for (const auto& entry : std::filesystem::directory_iterator(source_file("shaders"))) {
            std::ifstream file(entry.path());
            shader_texts()[entry.path().filename().string()].assign(std::istreambuf_iterator<char>(file), {});
        }
        update();
    }

    // Changes one place of a shader.
    static void replace(const std::string& file, const std::string& old, const std::string& changed) {
        std::string& text = shader_texts()[file];
        const std::size_t at = text.find(old);
        ASSERT_NE(at, std::string::npos) << file << " has no " << old;
        text.replace(at, old.size(), changed);
        update();
    }

    static void update() {
        shaders().clear();
        for (const auto& [name, text] : shader_texts()) shaders()[name] = text;
    }

    // What make_program() says of trace.frag, or "" if it is content.
    static std::string fault() {
        try {
            make_program("trace.frag", {"SPHERE_CAPACITY 1024"});
            return "";
        } catch (const RenderError& error) {
            return error.what();
        }
    }
};

class ShaderInContext : public ShaderTest, public testing::WithParamInterface<ContextKind> {
protected:
    std::unique_ptr<GlContext> context_ = GetParam().open();
};

TEST_P(ShaderInContext, AsItIsCompiles) { EXPECT_EQ(fault(), ""); }

TEST_P(ShaderInContext, WithAFrameThatTheProgramDoesNotShareIsRefused) {
    replace("draw.glsl", "    vec4 right;\n    vec4 up;\n", "    vec4 up;\n    vec4 right;\n");
    EXPECT_EQ(fault(), "trace.frag: GL has Frame.right at byte 32, the program at 16");
}

TEST_P(ShaderInContext, WithAFrameThatLacksAMemberIsRefused) {
    replace("draw.glsl", "vec4 background;", "vec4 backdrop;");
    EXPECT_EQ(fault(), "trace.frag: GL has Frame.background at byte -1, the program at 48");
}

TEST_P(ShaderInContext, ErrorsNameTheFileAndLineAsWritten) {
    // A file, and the line in it where a mistake is put.
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"trace.frag", "out int visible;"},
        {"trace.frag", "void main()"},
        {"spheres.glsl", "vec4 sphere_at(int index) { return center_radius"},
        {"visible.glsl", "const int visible_background"}};
    for (const auto& [file, line] : cases) {
        const std::string& text = shader_texts()[file];
        const auto number = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(line)), '\n');
        replace(file, line, "this_is_no_type " + line);
        EXPECT_TRUE(contains(fault(), "the shader trace.frag does not compile:\n" + file + ":" + std::to_string(number) + "("));
        replace(file, "this_is_no_type " + line, line);
    }
    EXPECT_EQ(fault(), "");
}

TEST_P(ShaderInContext, ThatDoesNotLinkSaysSo) {
    replace("trace.frag", "void main()", "void not_main()");
    EXPECT_TRUE(contains(fault(), "the shader trace.frag does not link"));
}

INSTANTIATE_TEST_SUITE_P(Contexts, ShaderInContext, testing::ValuesIn(context_kinds()), testing::PrintToStringParamName());

TEST_F(ShaderTest, IncludesAreTakenOnceAndLinesKeepTheirNumbers) {
    shader_texts() = {{"main.frag", "#version 330 core\n#include \"a.glsl\"\n#include \"b.glsl\"\nvoid main() {}\n"},
                      {"a.glsl", "#include \"b.glsl\"\nint a;\n"},
                      {"b.glsl", "int b;\n"}};
    update();
    const ShaderSource source = assemble_shader("main.frag", {"X 1", "Y 2"});
    EXPECT_EQ(source.files, (std::vector<std::string>{"main.frag", "a.glsl", "b.glsl"}));
    EXPECT_EQ(source.text,
              "#version 330 core\n#define X 1\n#define Y 2\n#line 2 0\n"
              "#line 1 1\n#line 1 2\nint b;\n#line 2 1\nint a;\n#line 3 0\n#line 4 0\nvoid main() {}\n");
}

TEST_F(ShaderTest, AMissingFileIsNamed) {
    replace("trace.frag", "\"rays.glsl\"", "\"ray.glsl\"");
    try {
        assemble_shader("trace.frag", {});
        ADD_FAILURE() << "no error";
    } catch (const RenderError& error) {
        EXPECT_STREQ(error.what(), "the shader file 'ray.glsl' is missing");
    }
}

TEST(ShaderLog, NamesFilesWhoeverWroteIt) {
    const std::vector<std::string> files = {"trace.frag", "draw.glsl"};
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"0:12(5): error: `x' undeclared", "trace.frag:12(5): error: `x' undeclared\n"},                               // Mesa
        {"1:3(1): warning: unused\n", "draw.glsl:3(1): warning: unused\n"},                                            // Mesa
        {"0(12) : error C1008: undefined variable \"x\"", "trace.frag:12 : error C1008: undefined variable \"x\"\n"},  // NVIDIA
        {"ERROR: 0:12: 'x' : undeclared identifier", "ERROR: trace.frag:12: 'x' : undeclared identifier\n"},           // Apple, AMD
        {"ERROR: 1:3: bad\nERROR: 0:4: worse", "ERROR: draw.glsl:3: bad\nERROR: trace.frag:4: worse\n"},
        {"7:12(5): error: another source", "7:12(5): error: another source\n"},  // no such file
        {"error C0000: version 330:1", "error C0000: version 330:1\n"},
        {"1 error generated", "1 error generated\n"},
        {"", ""},
    };
    for (const auto& [log, named] : cases) EXPECT_EQ(name_files_in_log(log, files), named);
}

}  // namespace
}  // namespace test
}  // namespace sphereview

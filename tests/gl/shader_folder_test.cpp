// Shaders that are wrong, what their log says, and shaders that a person edits while the picture is shown.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "base/error.hpp"
#include "gl/contexts.hpp"
#include "gl/live.hpp"
#include "gpu/program.hpp"
#include "support/folders.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

class ShaderFolderTest : public InContext {
protected:
    ShaderFolderTest() {
        for (const auto& entry : std::filesystem::directory_iterator(source_file("shaders"))) {
            std::filesystem::copy(entry.path(), folder_.path(entry.path().filename().string()));
        }
    }

    void replace(const std::string& file, const std::string& old, const std::string& changed) const {
        std::string text = folder_.read(file);
        const std::size_t at = text.find(old);
        ASSERT_NE(at, std::string::npos) << file << " has no " << old;
        folder_.write(file, text.replace(at, old.size(), changed));
    }

    static std::string place(const std::string& file, const std::string& text, const std::string& what) {
        const auto begin = text.begin();
        return file + ":" + std::to_string(1 + std::count(begin, begin + static_cast<std::ptrdiff_t>(text.find(what)), '\n'));
    }

    // What is wrong with the folder's trace.frag, or "".
    std::string fault() const {
        try {
            make_program("trace.frag", {"SPHERE_CAPACITY 1024"}, ShaderFiles(folder_.path()));
            return "";
        } catch (const RenderError& error) {
            return error.what();
        }
    }

    TemporaryFolder folder_;
    Document document_{two_spheres()};
    View view_{{}, {60, 60}};
};

TEST_P(ShaderFolderTest, WithAFrameThatTheProgramDoesNotShareIsRefused) {
    replace("draw.glsl", "vec4 right;", "vec4 other;");
    replace("draw.glsl", "vec4 up;", "vec4 right;");
    replace("draw.glsl", "vec4 other;", "vec4 up;");
    EXPECT_EQ(fault(), "trace.frag: GL has Draw.right at byte 32, the program at 16");
}

TEST_P(ShaderFolderTest, WithAFrameThatLacksAMemberIsRefused) {
    replace("draw.glsl", "vec4 background;", "vec4 backdrop;");
    EXPECT_EQ(fault(), "trace.frag: GL has Draw.background at byte -1, the program at 48");
}

TEST_P(ShaderFolderTest, ErrorsNameTheFileAndLineAsWritten) {
    // A file, and the line in it where a mistake is put.
    for (const auto& [file, line] :
         std::vector<std::pair<std::string, std::string>>{{"trace.frag", "out int visible;"},
                                                          {"trace.frag", "void main()"},
                                                          {"spheres.glsl", "vec4 sphere_at(int index) { return center_radius"},
                                                          {"visible.glsl", "const int visible_background"}}) {
        const std::string where = place(file, folder_.read(file), line);
        replace(file, line, "this_is_no_type " + line);
        EXPECT_TRUE(contains(fault(), "the shader trace.frag does not compile:\n" + where + "("));
        replace(file, "this_is_no_type " + line, line);
    }
    EXPECT_EQ(fault(), "");
}

TEST_P(ShaderFolderTest, ThatDoesNotLinkSaysSo) {
    replace("trace.frag", "void main()", "void not_main()");
    EXPECT_TRUE(contains(fault(), "the shader trace.frag does not link"));
}

TEST_P(ShaderFolderTest, ABrokenShaderLeavesTheLastGoodOneAndAFixedOneTakesOver) {
    LivePicture picture(folder_.path());
    EXPECT_EQ(picture.shader_log(), "");
    const Image before = shown(picture, document_, view_);
    EXPECT_EQ(at(before, 30, 30), opaque(red));

    replace("trace.frag", "out int visible;", "out int visible = broken;");
    const std::string expected = place("trace.frag", folder_.read("trace.frag"), "broken");
    const std::string log = picture.reload_shaders();
    EXPECT_TRUE(contains(log, expected)) << log;
    EXPECT_EQ(picture.shader_log(), log);
    EXPECT_TRUE(same(shown_again(picture, document_, view_), before));
    document_.apply(change(0, {{0, 0, 200}, 45, red, false}), "grow");
    EXPECT_EQ(at(shown(picture, document_, view_), 30, 30), opaque(red));  // also to trace with

    replace("trace.frag", "out int visible = broken;", "out int visible;");
    replace("trace.frag", "visible = decided ? guess : doubtful(guess);", "visible = -1;");
    EXPECT_EQ(picture.reload_shaders(), "");
    EXPECT_EQ(picture.shader_log(), "");
    EXPECT_EQ(at(shown(picture, document_, view_), 30, 30), opaque({0, 0, 0}));
}

TEST_P(ShaderFolderTest, AChangedShaderOrIncludedFileIsInThePictureAtOnce) {
    LivePicture picture(folder_.path());
    shown(picture, document_, view_);
    replace("shade.frag", "vec4(color_at(index).rgb, 1.0)", "vec4(0.0, 1.0, 0.0, 1.0)");
    EXPECT_EQ(picture.reload_shaders(), "");
    EXPECT_EQ(at(shown(picture, document_, view_), 30, 30), opaque({0, 255, 0}));
    replace("window.glsl", "window_corner.y - at.y", "at.y");
    replace("shade.frag", "vec4(0.0, 1.0, 0.0, 1.0)", "vec4(0.0, float(pixel.y) / 255.0, 0.0, 1.0)");
    EXPECT_EQ(picture.reload_shaders(), "");
    EXPECT_EQ(at(shown(picture, document_, view_), 30, 25), opaque({0, 59 - 25, 0}));

    // A mistake in a file that several include is named there.
    replace("filter.glsl", "float root(float x)", "float root(flat x)");
    const std::string log = picture.reload_shaders();
    EXPECT_TRUE(contains(log, place("filter.glsl", folder_.read("filter.glsl"), "float root(flat x)"))) << log;
    EXPECT_EQ(at(shown_again(picture, document_, view_), 30, 25), opaque({0, 59 - 25, 0}));
}

// It does without all that the program would tell it.
TEST_P(ShaderFolderTest, AShaderMayBeAsSimpleAsCanBe) {
    folder_.write("shade.frag", "#version 330 core\r\nout vec4 color;\r\nvoid main() { color = vec4(1.0); }");
    LivePicture picture(folder_.path());
    EXPECT_EQ(picture.shader_log(), "");
    EXPECT_EQ(at(shown(picture, document_, view_), 1, 1), opaque({255, 255, 255}));
}

TEST_P(ShaderFolderTest, WhatTheFolderLacksIsTheProgramsOwn) {
    TemporaryFolder other;
    ASSERT_EQ(mkfifo(other.path("fifo.glsl").c_str(), 0600), 0);  // is not waited for
    other.write("shade.frag", "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(0.0, 0.0, 1.0, 1.0); }\n");
    other.write(".#trace.frag", "an editor's");
    other.write("notes.txt", "no shader");
    LivePicture picture(other.path());
    EXPECT_EQ(at(shown(picture, document_, view_), 1, 1), opaque({0, 0, 255}));
    std::filesystem::remove(other.path("shade.frag"));
    ASSERT_EQ(mkfifo(other.path("shade.frag").c_str(), 0600), 0);
    const std::string no_file = "the shader file 'shade.frag' is no regular file";
    EXPECT_EQ(picture.reload_shaders(), no_file);
    EXPECT_EQ(at(shown_again(picture, document_, view_), 1, 1), opaque({0, 0, 255}));
    EXPECT_EQ(LivePicture(other.path()).shader_log(), no_file) << "at the start the program's own are used";
    for (const char* name : {"shade.frag", "fifo.glsl"}) std::filesystem::remove(other.path(name));
    EXPECT_EQ(picture.reload_shaders(), other.path() + ": no shaders in it, expected files like trace.frag");
    other.write("shade.frag", "#version 330 core\n#include \"nowhere.glsl\"\n");
    EXPECT_EQ(picture.reload_shaders(), "the shader file 'nowhere.glsl' is missing");
    EXPECT_EQ(at(shown_again(picture, document_, view_), 1, 1), opaque({0, 0, 255}));
}

TEST_P(ShaderFolderTest, ThatIsBrokenAtTheStartGivesTheProgramsOwnShadersAndItsLog) {
    replace("shade.frag", "out vec4 color;", "out vec5 color;");
    LivePicture picture(folder_.path());
    EXPECT_TRUE(contains(picture.shader_log(), place("shade.frag", folder_.read("shade.frag"), "vec5"))) << picture.shader_log();
    EXPECT_EQ(at(shown(picture, document_, view_), 30, 30), opaque(red));
    EXPECT_THROW(LivePicture(folder_.path("nowhere")), InputError);
}

// Spheres in textures need other shaders, which are compiled when they are needed.
TEST_P(ShaderFolderTest, ThatIsBrokenForManySpheresOnlyIsFoundThen) {
    replace("spheres.glsl", "vec4 sphere_at(int index) { return table_fetch", "vec4 sphere_at(int index) { return tabel_fetch");
    LivePicture picture(folder_.path());
    EXPECT_EQ(picture.shader_log(), "");
    Scene many = two_spheres();
    for (int i = 0; i < 5000; ++i) many.spheres.push_back({{i, 200, -100}, 1, blue, false});
    EXPECT_EQ(at(shown(picture, Document(many), view_), 30, 30), opaque(red));
    EXPECT_TRUE(contains(picture.shader_log(), "tabel_fetch")) << picture.shader_log();
}

TEST_P(ShaderFolderTest, WithoutOneThereIsNothingToReload) {
    LivePicture picture;
    shown(picture, document_, view_);
    EXPECT_EQ(picture.reload_shaders(), "");
    EXPECT_FALSE(picture.update(document_, view_, 1));
}

TEST(ShaderIncludes, AreTakenOnceAndLinesKeepTheirNumbers) {
    const TemporaryFolder folder;
    folder.write("main.frag", "#version 330 core\n#include \"a.glsl\"\n#include \"b.glsl\"\nvoid main() {}\n");
    folder.write("a.glsl", "#include \"b.glsl\"\nint a;\n");
    folder.write("b.glsl", "int b;\n");
    const ShaderSource source = assemble_shader("main.frag", {"X 1", "Y 2"}, ShaderFiles(folder.path()));
    EXPECT_EQ(source.files, (std::vector<std::string>{"main.frag", "a.glsl", "b.glsl"}));
    EXPECT_EQ(source.text,
              "#version 330 core\n#define X 1\n#define Y 2\n#line 2 0\n"
              "#line 1 1\n#line 1 2\nint b;\n#line 2 1\nint a;\n#line 3 0\n#line 4 0\nvoid main() {}\n");
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

INSTANTIATE_TEST_SUITE_P(Contexts, ShaderFolderTest, testing::ValuesIn(context_kinds()), testing::PrintToStringParamName());

}  // namespace
}  // namespace sphereview::test

// What doctor says of a machine where everything works (Mesa's llvmpipe and OSMesa).
#include <gtest/gtest.h>

#include "app/version.hpp"
#include "support/json.hpp"
#include "support/program.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

TEST(Doctor, TriesEveryBackendAndDescribesIt) {
    const Outcome outcome = run({"doctor", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(lines(outcome.output).size(), 1U);
    const Json report = Json::parse(outcome.output);
    EXPECT_EQ(report["version"], version);
    std::vector<std::string> working;
    for (const Json& row : report["backends"]) {
        SCOPED_TRACE(row.dump());
        EXPECT_FALSE(row["name"].get<std::string>().empty());
        EXPECT_TRUE(row.contains("device"));
        if (!row["works"].get<bool>()) {
            EXPECT_FALSE(row["reason"].get<std::string>().empty());
            EXPECT_FALSE(row["advice"].get<std::string>().empty());
            continue;
        }
        working.push_back(row["backend"]);
        if (row["backend"] == "cpu") continue;
        for (const char* text : {"vendor", "renderer", "version", "glsl"})
            EXPECT_FALSE(row[text].get<std::string>().empty()) << text;
        EXPECT_TRUE(row["software"].is_boolean());
        EXPECT_GE(row["largest_uniform_block_bytes"].get<int>(), 16384);
        EXPECT_GE(row["spheres_in_uniform_block"].get<int>(), 1024);
        EXPECT_GE(row["largest_texture_side"].get<int>(), 1024);
    }
    EXPECT_EQ(working.front(), "egl");
    EXPECT_EQ(report["backends"][0]["device"], 0);
    EXPECT_EQ(working[working.size() - 2], "osmesa");
    EXPECT_EQ(working.back(), "cpu");
}

TEST(Doctor, SaysTheSameInWords) {
    const Outcome outcome = run({"doctor"});
    ASSERT_EQ(outcome.status, 0) << outcome;
    for (const char* part : {"EGL device 0: works", "OSMesa: works", "CPU: works", "renderer:  llvmpipe",
                             "vendor:    ", "OpenGL:    ", "uniform block ", "texture side ", "use:       --backend egl --device 0",
                             "use:       --backend osmesa"}) {
        EXPECT_TRUE(contains(outcome.output, part));
    }
}

TEST(Doctor, AsksForNoDriverWhereOnlyTheDefaultDisplayFails) {
    const Json report =
        Json::parse(run({"doctor", "--json"}, {{"DISPLAY", std::nullopt}, {"WAYLAND_DISPLAY", std::nullopt}}).output);
    bool met = false;
    for (const Json& row : report["backends"]) {
        if (row["name"] != "EGL default display" || row["works"].get<bool>()) continue;
        met = true;
        EXPECT_TRUE(row["advice"].get<std::string>().ends_with("and EGL device 0 works")) << row;
    }
    if (!met) GTEST_SKIP() << "the default display works here";
}

TEST(Doctor, SaysWhyADriverDoesNotServeAndWhatToDo) {
    const Outcome outcome = run({"doctor"}, {{"MESA_GL_VERSION_OVERRIDE", "3.2"}});
    EXPECT_EQ(outcome.status, 0) << outcome;  // the CPU works
    EXPECT_TRUE(
        contains(outcome.output, "EGL device 0: does not work\n    why:       eglCreateContext for OpenGL 3.3 core failed"));
    EXPECT_TRUE(contains(
        outcome.output,
        "OSMesa: does not work\n    why:       OSMesa has no OpenGL 3.3 core context\n    try:       it needs OpenGL 3.3"));
}

TEST(Doctor, ThatCannotWriteFails) {
    EXPECT_EQ(run({.arguments = {"doctor", "--json"}, .output = StandardOutput::full_disk}).status, 4);
}

}  // namespace
}  // namespace sphereview::test

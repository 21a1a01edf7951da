// Which renderer draws, and what is said of the others. Mesa's variables make it an old driver, or one that is not there.
#include <gtest/gtest.h>

#include <filesystem>
#include <thread>

#include "support/json.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

constexpr const char* old_driver = "MESA_GL_VERSION_OVERRIDE";

class BackendChoice : public testing::Test {
protected:
    BackendChoice() { folder_.write("red.txt", red_scene); }

    Outcome render_small(const std::vector<std::string>& arguments, const Environment& environment = {}) const {
        return run(
            {.arguments = all_words({"render", "-s", "5x5"}, arguments), .folder = folder_.path(), .environment = environment});
    }

    TemporaryFolder folder_;
};

TEST_F(BackendChoice, AutomaticPrefersEgl) {
    for (const Environment& environment :
         {Environment{}, Environment{{"LIBGL_ALWAYS_SOFTWARE", "1"}}, Environment{{"SPHEREVIEW_BACKEND", "auto"}}}) {
        const Outcome outcome = render_small({"red.txt", "--verbose"}, environment);
        EXPECT_EQ(outcome.status, 0) << outcome;
        EXPECT_TRUE(matches(line_with(outcome.errors, "backend:"), "red\\.txt: backend: egl \\(EGL device [0-9]+, .+\\).*"));
    }
}

TEST_F(BackendChoice, AlwaysSoftwareIsRespected) {
    const Outcome outcome = render_small({"red.txt", "--verbose"}, {{"LIBGL_ALWAYS_SOFTWARE", "true"}});
    EXPECT_TRUE(contains(outcome.errors, "llvmpipe")) << outcome;
}

// A processor that stands for a GPU draws one frame with all cores; without it each core has a frame of its own.
TEST_F(BackendChoice, SeveralFramesAreDrawnInSoftwareByTheCpuAlone) {
    if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "there is one core";
    folder_.write("a.xyz", "1\n\nO 0 0 0\n1\n\nO 1 0 0\n");
    const Environment software = {{"LIBGL_ALWAYS_SOFTWARE", "1"}};
    const Outcome outcome = render_small({"a.xyz", "--frames", "all", "--verbose"}, software);
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_TRUE(
        matches(line_with(outcome.errors, "backend:"), "a\\.xyz, 0: backend: cpu; passed over: .*egl .*one frame at a time.*"))
        << outcome;
    const std::string picture = folder_.read("a-00001.png");
    const Outcome named = render_small({"a.xyz", "--frames", "all", "--verbose", "--backend", "egl"}, software);
    EXPECT_TRUE(contains(named.errors, "a.xyz, 1: backend: egl (EGL device")) << named;
    EXPECT_TRUE(folder_.read("a-00001.png") == picture);
}

TEST_F(BackendChoice, NamesAreObeyed) {
    for (const char* name : {"egl", "osmesa", "cpu"}) {
        const Outcome option = render_small({"red.txt", "--json", "--backend", name}, {{"SPHEREVIEW_BACKEND", "auto"}});
        const Outcome variable = render_small({"red.txt", "--json"}, {{"SPHEREVIEW_BACKEND", name}});
        ASSERT_EQ(option.status, 0) << option;
        ASSERT_EQ(variable.status, 0) << variable;
        EXPECT_EQ(Json::parse(option.output)["backend"], name);
        EXPECT_EQ(Json::parse(variable.output)["backend"], name);
    }
}

TEST_F(BackendChoice, FallsBackToOsmesaWhereEglHasNoDriver) {
    const Outcome outcome =
        render_small({"red.txt", "--verbose"}, {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere"}, {"DISPLAY", std::nullopt}});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_TRUE(matches(line_with(outcome.errors, "backend:"), "red\\.txt: backend: osmesa \\(.*\\); passed over: EGL.*"));
}

TEST_F(BackendChoice, FallsBackToTheCpuWhereNoGlServesAndSaysWhyButReplacesNoNamedBackend) {
    for (const char* name : {"libEGL.so.1", "libEGL.so", "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
        folder_.write(std::string("lib/") + name, "not a library");
    }
    struct Machine {
        std::pair<std::string, std::string> variable;
        std::string egl;
        std::string osmesa;
    };
    const std::vector<Machine> machines = {
        {{old_driver, "3.2"}, "EGL device 0: .*3\\.3.*", "OSMesa: .*3\\.3.*"},
        {{"LD_LIBRARY_PATH", FAKE_DRIVERS "/bare"}, "EGL: libEGL .*", "OSMesa: libOSMesa .*"},  // without functions
        {{"LD_LIBRARY_PATH", folder_.path("lib")}, "EGL: libEGL .*", "OSMesa: libOSMesa .*"},
    };
    for (const auto& [variable, egl, osmesa] : machines) {
        SCOPED_TRACE(variable.second);
        const std::string backend = "the backend [a-z]+ does not work here: ";
        for (const auto& [options, named, why] : {std::tuple{std::vector<std::string>{"--backend", "egl"}, "", backend + egl},
                                                  {{"--backend", "osmesa"}, "", backend + osmesa},
                                                  {{"--device", "0"}, "", egl.substr(egl.find(": ") + 2)},
                                                  {{}, "egl", backend + egl}}) {
            const Outcome outcome =
                render_small(all_words({"red.txt"}, options),
                             {variable, {"SPHEREVIEW_BACKEND", *named == 0 ? std::nullopt : std::optional(named)}});
            EXPECT_EQ(outcome.status, 3) << outcome;
            EXPECT_TRUE(matches(outcome.errors, "red\\.txt: " + why + "\n"));
            EXPECT_EQ(lines(outcome.errors).size(), 1U) << outcome;
            EXPECT_FALSE(folder_.has("red.png"));
        }
        const Outcome outcome = render_small({"red.txt", "--verbose"}, {variable});
        EXPECT_EQ(outcome.status, 0) << outcome;
        EXPECT_TRUE(matches(line_with(outcome.errors, "backend:"), "red\\.txt: backend: cpu; passed over: " + egl + "; " + osmesa));
        EXPECT_EQ(render_small({"red.txt"}, {variable}).errors, "");
        EXPECT_EQ(decode_png(folder_.read("red.png")).at(2, 2), (std::vector<int>{255, 0, 0}));
        std::filesystem::remove(folder_.path("red.png"));
    }
}

#ifndef SPHEREVIEW_SANITIZED  // AddressSanitizer reserves more address space than any sensible limit
// Mesa crashes at some of these limits.
TEST_F(BackendChoice, TooLittleAddressSpaceForADriverIsForTheCpu) {
    Command command;
    command.folder = folder_.path();
    for (const rlim_t megabytes : {225, 250, 400, 450, 525, 600}) {
        command.most_memory = megabytes * 1'000'000;
        command.arguments = {"render", "red.txt", "-s", "5x5", "--verbose"};
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 0) << megabytes << ": " << outcome;
        EXPECT_TRUE(matches(line_with(outcome.errors, "backend:"),
                            "red\\.txt: backend: cpu; passed over: GL: a GL driver may need .* of address space, .*"));
        for (const char* backend : {"egl", "osmesa"}) {
            command.arguments = {"render", "red.txt", "-s", "5x5", "--backend", backend};
            const Outcome named = run(command);
            EXPECT_EQ(named.status, 3) << megabytes << ": " << named;
            EXPECT_TRUE(named.errors.starts_with("red.txt: a GL driver may need ")) << named;
        }
    }
    command.arguments = {"doctor"};
    const Outcome doctor = run(command);
    EXPECT_TRUE(contains(doctor.output, "why:       a GL driver may need "));
    EXPECT_TRUE(contains(doctor.output, "try:       raise that limit, or use --backend cpu"));
}
#endif

TEST_F(BackendChoice, MoreSpheresThanTheUniformBufferHoldsAreInTextures) {
    const int capacity = Json::parse(run({"doctor", "--json"}).output)["backends"][0]["spheres_in_uniform_block"].get<int>();
    EXPECT_GE(capacity, 1024);
    folder_.write("full.txt", many_spheres(capacity));
    folder_.write("many.txt", many_spheres(capacity + 1));
    for (const char* backend : {"auto", "egl", "osmesa"}) {
        const Outcome outcome = render_small({"many.txt", "full.txt", "red.txt", "--backend", backend, "--verbose"});
        EXPECT_EQ(outcome.status, 0) << outcome;
        EXPECT_TRUE(contains(line_with(outcome.errors, "many.txt: tiles"), "spheres in buffer textures"));
        EXPECT_TRUE(contains(line_with(outcome.errors, "full.txt: tiles"), "spheres in uniform buffer"));
        EXPECT_EQ(decode_png(folder_.read("full.png")).at(2, 2), (std::vector<int>{1, 2, 3}));
        EXPECT_EQ(decode_png(folder_.read("many.png")).at(2, 2), (std::vector<int>{1, 2, 3}));
        EXPECT_EQ(decode_png(folder_.read("red.png")).at(2, 2), (std::vector<int>{255, 0, 0}));
    }
}

TEST_F(BackendChoice, SeveralScenesShareOneContext) {
    folder_.write("blue.txt", blue_scene);
    for (const char* backend : {"egl", "osmesa"}) {
        const Outcome outcome = render_small({"red.txt", "blue.txt", "--backend", backend, "--json"});
        ASSERT_EQ(outcome.status, 0) << outcome;
        const auto rows = lines(outcome.output);
        ASSERT_EQ(rows.size(), 2U);
        for (const char* phase : {"context", "shaders"}) {
            EXPECT_GT(Json::parse(rows[0])["timings_ms"][phase].get<double>(), 0.0);
            EXPECT_EQ(Json::parse(rows[1])["timings_ms"][phase].get<double>(), 0.0);
        }
        for (const char* phase : {"read", "prepare", "trace", "read back", "resolve", "encode", "write"}) {
            EXPECT_GT(Json::parse(rows[1])["timings_ms"][phase].get<double>(), 0.0) << phase;
        }
        EXPECT_EQ(decode_png(folder_.read("blue.png")).at(2, 2), (std::vector<int>{0, 0, 250}));
    }
}

TEST_F(BackendChoice, ADeviceIsPickedByNumber) {
    const Outcome outcome = render_small({"red.txt", "--device", "0", "--verbose"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_TRUE(outcome.errors.starts_with("red.txt: backend: egl (EGL device 0, ")) << outcome;
    // A device counts more than the variable, which names no device.
    EXPECT_TRUE(
        contains(render_small({"red.txt", "--device", "0", "--verbose"}, {{"SPHEREVIEW_BACKEND", "cpu"}}).errors, "backend: egl"));
    for (const char* number : {"99", "-1"}) {
        const Outcome missing = render_small({"red.txt", "--device", number});
        EXPECT_EQ(missing.status, 2) << missing;
        EXPECT_TRUE(contains(missing.errors, std::string("--device: found '") + number + "', expected ")) << missing;
    }
}

}  // namespace
}  // namespace sphereview::test

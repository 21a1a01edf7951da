// What the window writes beside its loop, where nobody takes it or no thread can write it. Without a window.
#include "viewer/scene_work.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <fstream>
#include <sstream>

#include "app/failure.hpp"
#include "base/background_job.hpp"
#include "support/eventually.hpp"
#include "support/no_threads.hpp"
#include "support/temporary_folder.hpp"
#include "viewer/box_selection.hpp"
#include "viewer/perform.hpp"
#include "viewer/scene_file.hpp"

namespace sphereview {

namespace {

using namespace std::chrono_literals;

struct Outputs : testing::Test {
    Outputs() : state(ViewOptions{}, ViewerSettings{}) {
        adopt(state, load_scene(folder.write("scene.txt", "1\n1 2 3 0 0 300 60\n")), folder.path("scene.txt"));
        state.settings.export_width = state.settings.export_height = 64;
        state.picture_size = {64, 64};
        mkfifo(folder.path("pipe.toml").c_str(), 0600);
        mkfifo(folder.path("pipe.png").c_str(), 0600);
    }

    // Chooses a name in the dialog of a command.
    void choose(CommandId command, const std::string& name) {
        run_command(state, command);
        ASSERT_FALSE(state.dialogs.empty());
        const auto accept = std::get<FileBrowser>(state.dialogs.back()).accept;
        state.dialogs.clear();
        accept(folder.path(name), {64, 64});
    }
    // What the loop does from redraw to redraw; whether nothing is under way any more.
    bool is_finished() {
        finish_work(state);
        return !is_working(state);
    }
    std::string take(const std::string& fifo) {
        std::ostringstream bytes;
        bytes << std::ifstream(folder.path(fifo)).rdbuf();
        return bytes.str();
    }
    std::string error() const { return state.dialogs.empty() ? "" : std::get<Question>(state.dialogs.back()).text; }

    test::TemporaryFolder folder;
    ViewerState state;
};

constexpr const char* no_threads = "the system allows no more threads";

}  // namespace

// Whoever catches all has words for it.
TEST(Failures, OfCancelledWorkAreDescribed) {
    try {
        throw Cancelled();
    } catch (...) {
        EXPECT_EQ(describe_current_exception("scene.txt").message, "scene.txt: cancelled");
    }
}

TEST_F(Outputs, AFifoThatNobodyReadsHoldsUpNobody) {
    choose(CommandId::export_picture, "pipe.png");
    choose(CommandId::file_save_as, "pipe.toml");
    // Both write, or would if somebody read.
    ASSERT_TRUE(test::eventually([&] { return state.exporting->job.control().writes.load(); }));
    EXPECT_FALSE(is_finished());
    EXPECT_TRUE(state.saving && state.exporting);
    EXPECT_TRUE(take("pipe.png").starts_with("\x89PNG"));
    EXPECT_NE(take("pipe.toml").find("[[sphere]]"), std::string::npos);
    EXPECT_TRUE(test::eventually([&] { return is_finished(); }));
    EXPECT_EQ(state.path, folder.path("pipe.toml"));
    EXPECT_TRUE(state.dialogs.empty()) << error();
}

TEST_F(Outputs, AnExportThatIsCancelledWhileItIsWrittenSaysSo) {
    choose(CommandId::export_picture, "pipe.png");
    ASSERT_TRUE(test::eventually([&] { return state.exporting->job.control().writes.load(); }));
    cancel_work(state);
    EXPECT_FALSE(is_working(state));
    EXPECT_EQ(state.messages.announcement, "Cancelled too late: the picture may be written all the same");
    take("pipe.png");
}

TEST_F(Outputs, AreWaitedForByAWindowThatIsClosedOnceButNotTwice) {
    choose(CommandId::export_picture, "pipe.png");
    ASSERT_TRUE(test::eventually([&] { return state.exporting->job.control().writes.load(); }));
    run_command(state, CommandId::quit);
    EXPECT_FALSE(state.quits);
    EXPECT_NE(state.messages.announcement.find("close again"), std::string::npos) << state.messages.announcement;
    run_command(state, CommandId::quit);
    EXPECT_TRUE(state.quits);
    take("pipe.png");
}

TEST_F(Outputs, TheEndOfTheWindowWaitsSomeTimeForThem) {
    choose(CommandId::export_picture, "pipe.png");
    choose(CommandId::file_save_as, "pipe.toml");
    finish_writing(state, 10ms);
    EXPECT_TRUE(state.saving) << "it is not saved";
    EXPECT_FALSE(state.exporting);
    take("pipe.toml");
    finish_writing(state, 30s);
    EXPECT_FALSE(state.saving);
}

TEST_F(Outputs, TheNextFreeNameIsFoundBesideTheLoop) {
    folder.write("scene.png", "mine");
    run_command(state, CommandId::export_now);
    ASSERT_TRUE(state.exporting.has_value());
    state.exporting->job.wait();
    EXPECT_EQ(state.exporting->shown_path(), folder.path("scene-1.png")) << "what the bar names";
    EXPECT_TRUE(test::eventually([&] { return is_finished(); }));
    EXPECT_EQ(state.messages.announcement, "Exported " + folder.path("scene-1.png") + " (64 x 64, 16 samples a pixel)");
    EXPECT_EQ(folder.read("scene.png"), "mine");
    EXPECT_TRUE(folder.has("scene-1.png"));
}

// Strengths of lights, changed one after the other: what is shown stays until the next is there, which is the export's.
TEST_F(Outputs, ThePictureAtRestIsRelitAtOnce) {
    run_command(state, CommandId::add_sphere);
    state.document.apply(ChangeLight{{.lights = 32, .sun = Sun{{1.0, 2.0, -3.0}}}}, "Switch the sun on");
    const auto made = [&] { return rest_picture_is_shown(state); };
    const auto seen = [] { return std::vector<std::int32_t>(64 * 64, visible_background); };
    make_rest_picture(state, seen);
    ASSERT_TRUE(test::eventually(made));
    ASSERT_TRUE(state.kept_lights && state.kept_lights->picture.get());
    const auto kept = state.kept_lights;
    const auto kept_picture = kept->picture.get();
    for (const auto& [sky, key, sun] : {std::array{0.5, 1.0, 1.0}, {0.5, 0.25, 1.0}, {0.2, 0.25, 0.001}, {0.2, 0.0, 4.0}}) {
        const std::shared_ptr<const Image> before = state.rest_picture->image;
        Light light = state.shown_light();
        light.sky = sky;
        light.key = key;
        light.sun->strength = sun;
        state.document.apply(ChangeLight{light}, "Change the light");
        EXPECT_FALSE(rest_picture_is_shown(state));
        ASSERT_TRUE(state.rest_picture);
        EXPECT_EQ(state.rest_picture->before, before);
        ASSERT_TRUE(test::eventually(made));
        // Nothing was decided again.
        EXPECT_EQ(state.kept_lights, kept);
        EXPECT_EQ(kept->picture.get(), kept_picture);
        OpenBackend cpu;
        Timings timings;
        PictureFacts facts;
        const Image expected = render_picture(cpu, state.scene(), drawn_spheres(state.scene(), state.camera),
                                              state.rest_picture->options, timings, facts, [](double) {});
        EXPECT_TRUE(std::ranges::equal(state.rest_picture->image->bytes(), expected.bytes()));
        EXPECT_FALSE(std::ranges::equal(before->bytes(), expected.bytes()));
    }
    // Another view has other shadows.
    state.camera.eye.x += 1.0;
    EXPECT_FALSE(rest_picture_is_shown(state));
    EXPECT_FALSE(state.rest_picture || state.kept_lights);
}

// Light takes its points by the million, whose trace alone may take long.
TEST(LitPicture, SaysHowMuchIsTracedOfItsFirstBlock) {
    Scene scene;
    for (int i = 0; i < 4000; ++i) scene.spheres.push_back({{0, 0, 1000 + i}, 900});  // each covers the picture
    OpenBackend cpu;
    Timings timings;
    PictureFacts facts;
    const PictureOptions options{.camera = scene.camera, .size = {1024, 64}, .background = {}, .shading = Shading::studio};
    const auto first = [&](double done) {
        EXPECT_GT(done, 0.0);
        EXPECT_EQ(timings[Phase::trace], 0.0) << "it was traced before";
        throw Cancelled();
    };
    EXPECT_THROW(render_picture(cpu, scene, drawn_spheres(scene), options, timings, facts, first), Cancelled);
}

TEST_F(Outputs, WithoutAThreadTheReasonIsSaid) {
    if (!test::NoThreads::possible) GTEST_SKIP() << "threads can always begin here";
    run_command(state, CommandId::add_sphere);
    {
        const test::NoThreads none;
        run_command(state, CommandId::export_now);
        is_finished();
        EXPECT_TRUE(error().ends_with(no_threads)) << error();
        state.dialogs.clear();
        choose(CommandId::file_save_as, "scene.toml");
        EXPECT_TRUE(error().ends_with(no_threads)) << error();
        EXPECT_TRUE(state.document.is_changed());
        state.dialogs.clear();
        select_seen(state, {0, 0, 64, 64}, false);
        EXPECT_EQ(error(), no_threads);
        make_rest_picture(state, [] { return std::vector<std::int32_t>{}; });
        EXPECT_FALSE(rest_picture_is_shown(state));
    }
    EXPECT_FALSE(folder.has("scene.toml") || folder.has("scene.png"));
}

}  // namespace sphereview

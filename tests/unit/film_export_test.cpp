// File > Export film, without a window: the pictures are those of `render --frames`, and a film is whole or not there.
#include "viewer/film_export.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <cstdlib>

#include "app/frame_sequence.hpp"
#include "app/picture_of_scene.hpp"
#include "image/png.hpp"
#include "support/eventually.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_match.hpp"
#include "viewer/film_job.hpp"
#include "viewer/perform.hpp"
#include "viewer/scene_file.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

// Three spheres each; the middle one is in front of the others.
constexpr const char* film_of_three =
    "3\nProperties=species:S:1:pos:R:3:charge:R:1\nO 0 0 0 0.5\nN 1 0 4 1\nC 2 0 0 2\n"
    "3\nProperties=species:S:1:pos:R:3:charge:R:1\nO 0 0.5 0 1\nN 1 0 4 1\nC 2 0 0 4\n"
    "3\nProperties=species:S:1:pos:R:3:charge:R:1\nO 0 1 0 1.5\nN 1 0 4 1\nC 2 0 0 6\n";

struct FilmExport : testing::Test {
    FilmExport() : path(folder.write("a.xyz", film_of_three)), state(ViewOptions{}, ViewerSettings{}) {
        std::signal(SIGPIPE, SIG_IGN);  // as in the program
        state.settings.samples = 1;
        state.settings.shading = Shading::headlight;
        open(path);
        const char* before = std::getenv("PATH");
        old_path = before == nullptr ? "" : before;
        setenv("PATH", (folder.path("bin") + ":/bin:/usr/bin").c_str(), 1);
    }
    ~FilmExport() override { setenv("PATH", old_path.c_str(), 1); }

    void open(const std::string& scene) {
        adopt(state, load_scene(scene, load_options(state, scene, 0)), scene);
        state.picture_size = size;
    }
    // A program `ffmpeg` that does what the script says; $film: the last argument.
    void write_encoder(const std::string& script) const {
        folder.write("bin/ffmpeg", "#!/bin/sh\nfor film; do :; done\n" + script + "\n");
        chmod(folder.path("bin/ffmpeg").c_str(), 0755);
    }
    // The form of the dialog, which is closed again.
    FilmForm form() {
        run_command(state, CommandId::export_film);
        FilmForm shown = *std::get<FileBrowser>(state.dialogs.back()).film;
        state.dialogs.clear();
        return shown;
    }
    FilmJudgement judged(
        const std::string& name, const std::function<void(FilmForm&)>& choose = [](FilmForm&) {}) {
        FilmForm chosen = form();
        choose(chosen);
        return chosen.judge(chosen, folder.path(name));
    }
    FilmRequest request(
        const std::string& name, const std::function<void(FilmForm&)>& choose = [](FilmForm&) {}) {
        FilmForm chosen = form();
        choose(chosen);
        return film_request(state, chosen, folder.path(name), size);
    }
    static void make(const FilmRequest& request) {
        WorkControl control;
        FilmStatus status;
        make_film(request, control, status);
        EXPECT_EQ(status.done(), status.pictures());
    }
    // The bytes of the pictures that `render` makes of a scene by the view in the window, one behind the other.
    std::string rendered(const std::string& scene, const std::function<void(RenderOptions&)>& ask) {
        Scene view;
        view.camera = state.camera;
        folder.write("view.toml", write_scene(view, SceneFormat::toml));
        RenderOptions options;
        options.scenes = {scene};
        options.size = size;
        options.fit.camera = folder.path("view.toml");
        options.background = state.shown_background();
        options.shading = state.settings.shading;
        options.backend = Backend::cpu;
        options.output = folder.path("rendered/{frame:05}.png");
        ask(options);
        EXPECT_EQ(run_render(options), ExitCode::done);
        return bytes("rendered");
    }
    std::string bytes(const std::string& name) const {
        std::string all;
        const test::TemporaryFolder& inside = folder;
        for (int i = 0; inside.has(picture(name, i)); ++i) all += inside.read(picture(name, i));
        return all;
    }
    static std::string picture(const std::string& name, int number) { return name + "/0000" + std::to_string(number) + ".png"; }
    std::string error() const { return state.dialogs.empty() ? "" : std::get<Question>(state.dialogs.back()).text; }
    bool is_finished() {
        finish_work(state);
        return !state.filming;
    }

    static constexpr PictureSize size{40, 30};
    test::TemporaryFolder folder;
    std::string path;
    std::string old_path;
    ViewerState state;
};

void take_all(RenderOptions& options) { options.frames.ranges = {FrameRange{}}; }

TEST_F(FilmExport, PicturesAreThoseOfRender) {
    state.camera.eye.x += 3.0;
    make(request("made/{frame:05}.png"));
    const std::string expected = rendered(path, take_all);
    EXPECT_EQ(bytes("made"), expected);
    EXPECT_TRUE(folder.has("made/00002.png"));

    const auto turning = [](FilmForm& form) {
        form.chosen.turns = true;
        form.chosen.turntable = 6;
        form.chosen.axis = TurnAxis::x;
        form.chosen.frames = "2,0";
    };
    make(request("turned/{frame:05}.png", turning));
    rendered(path, [](RenderOptions& options) {
        options.frames.ranges = {FrameRange{2, {}, 1, true}, FrameRange{0, {}, 1, true}};
        options.frames.turntable = 6;
        options.frames.axis = TurnAxis::x;
    });
    EXPECT_EQ(folder.read("turned/00000.png"), folder.read("rendered/00000.png"));
    EXPECT_EQ(folder.read("turned/00002.png"), folder.read("rendered/00002.png"));
    EXPECT_NE(folder.read("turned/00000.png"), folder.read("made/00000.png"));
}

// Of colours by a property the range is the window's, in all frames.
TEST_F(FilmExport, ShowsTheColoursOfTheWindow) {
    ViewOptions options;
    options.scene = path;
    options.look.color_by = "charge";
    state.options = options;
    open(path);
    state.settings.legend_shown = true;
    make(request("made/{frame:05}.png", [](FilmForm& form) { form.chosen.marks = true; }));
    const std::string expected = rendered(path, [](RenderOptions& render) {
        take_all(render);
        render.axes = true;
        render.legend = true;
        render.look.color_by = "charge";
        render.look.range = ValueRange{0.5, 2.0};  // of the frame that is shown
    });
    EXPECT_EQ(bytes("made"), expected);
}

TEST_F(FilmExport, MakesColoursRadiiAndWhatIsHiddenInAllFramesButNoPlaces) {
    Sphere first = state.scene().spheres[0];
    first.color = {1, 200, 3};
    first.radius *= 1.5;
    first.center.y += 1.0;
    Sphere hidden = state.scene().spheres[1];
    hidden.hidden = true;
    state.settings.shading = Shading::flat;
    apply(state, {ChangeSpheres{{0, 1}, {first, hidden}}, "An edit", 0});
    const FilmRequest asked = request("made/{frame:05}.png");
    make(asked);
    // The same spheres, in a file without the hidden one.
    RenderOptions alike = asked.options;
    alike.scenes = {folder.write("b.xyz", "2\n\nO 0 0 0\nC 2 0 0\n2\n\nO 0 0.5 0\nC 2 0 0\n2\n\nO 0 1 0\nC 2 0 0\n")};
    alike.output = folder.path("alike/{frame:05}.png");
    Progress progress;
    FrameSequence sequence(alike.scenes.front(), alike, progress);
    sequence.set_changes({.spheres = {{.number = 0, .color = first.color, .radius = first.radius}}});
    sequence.prepare(progress);
    for (const Shot& shot : sequence.shots()) {
        const LoadedScene loaded = sequence.load(shot);
        WorkControl control;
        const Image expected = render_beside(loaded.scene, picture_options(loaded, alike), control);
        EXPECT_EQ(folder.read(picture("made", static_cast<int>(shot.number))), encode_png(expected));
    }
    // What was changed before numbers were others than the file's holds.
    run_command(state, CommandId::add_sphere);
    EXPECT_TRUE(test::contains(form().from_file, "what was changed since is not in them"));
    make(request("later/{frame:05}.png"));
    EXPECT_EQ(bytes("later"), bytes("made"));
}

// As in the frames of the window: undoing brings the numbers back.
TEST_F(FilmExport, MakesChangesInAllFramesOnceADeletionIsUndone) {
    state.selection.set_only(1);
    run_command(state, CommandId::remove);
    EXPECT_TRUE(test::contains(form().from_file, "added, deleted or reordered"));
    undo(state);
    Sphere hidden = state.scene().spheres[0];
    hidden.hidden = true;
    apply(state, {ChangeSpheres{{0}, {hidden}}, "Hide", 0});
    EXPECT_EQ(reach_of_edits(state), EditsReach::all_frames);
    EXPECT_TRUE(test::contains(form().from_file, "hold in all"));
    EXPECT_EQ(request("again/{frame:05}.png").changes.spheres.size(), 1U);
}

TEST_F(FilmExport, GoesRoundWhatTheWindowShows) {
    run_command(state, CommandId::add_sphere);
    const auto around = [](FilmForm& form) {
        form.chosen.takes_frames = false;
        form.chosen.turns = true;
        form.chosen.turntable = 4;
    };
    make(request("made/{frame:05}.png", around));
    const std::string saved = folder.write("saved.toml", write_scene(state.scene(), SceneFormat::toml));
    EXPECT_EQ(bytes("made"), rendered(saved, [](RenderOptions& options) { options.frames.turntable = 4; }));
    EXPECT_TRUE(folder.has("made/00003.png"));
}

TEST_F(FilmExport, SaysBeforehandWhatItWillBe) {
    write_encoder("exit 1");
    EXPECT_EQ(judged("a.mp4").summary, "3 pictures, a film of 0.1 s");
    EXPECT_EQ(judged("a.mp4").fault, "");
    EXPECT_EQ(judged("{name}-{frame:05}.png").summary, "3 pictures: a-00000.png to a-00002.png");
    const auto around = [](FilmForm& form) {
        form.chosen.turns = true;
        form.chosen.frames = "-1";
        form.chosen.turntable = 4000;
        form.chosen.rate = "24000/1001";
    };
    EXPECT_EQ(judged("a.gif", around).summary, "4,000 pictures, a film of 2 min 47 s");
    const auto fault = [&](const std::function<void(FilmForm&)>& choose) { return judged("a.mp4", choose).fault; };
    EXPECT_TRUE(test::contains(fault([](FilmForm& f) { f.chosen.frames = "x"; }), "The frames are 'x', expected all, N, A:B"));
    EXPECT_TRUE(test::contains(fault([](FilmForm& f) { f.chosen.frames = "9"; }), "a.xyz: "));
    EXPECT_TRUE(test::contains(fault([](FilmForm& f) { f.chosen.rate = "0"; }), "The pictures a second are '0'"));
    EXPECT_TRUE(test::contains(fault([](FilmForm& f) { f.chosen.takes_frames = false; }), "Nothing is chosen"));
    const auto none_around = [](FilmForm& f) {
        f.chosen.turns = true;
        f.chosen.turntable = 0;
    };
    EXPECT_TRUE(test::contains(fault(none_around), "expected 1 to 1,000,000"));
    EXPECT_TRUE(judged("a.mp4").has_quality);
    EXPECT_FALSE(judged("a.mp4").has_alpha);
    EXPECT_TRUE(judged("a.mkv").has_alpha);
    EXPECT_TRUE(judged("a{frame}.png").has_alpha);
}

// Of a file that is still looked through more frames may come.
TEST_F(FilmExport, KnowsThatThereMayBeMoreFrames) {
    write_encoder("exit 1");
    state.player.all_frames = false;
    EXPECT_TRUE(test::contains(judged("a.mp4").summary, "At least 3 pictures"));
    const auto judged_frames = [&](const char* frames) { return judged("a.mp4", [=](FilmForm& f) { f.chosen.frames = frames; }); };
    EXPECT_EQ(judged_frames("9").fault, "");
    EXPECT_EQ(judged_frames("2000000").fault, "");
    EXPECT_TRUE(test::contains(judged_frames("0:100").summary, "At least 100 pictures"));
    // More than memory holds numbers.
    EXPECT_TRUE(test::contains(judged_frames("0:1000000000000").summary, "At least 1,000,000 pictures"));
    EXPECT_TRUE(test::contains(judged_frames("9223372036854775806:9223372036854775807").fault, "found no frame"));
}

// Also while its dialog stands.
TEST_F(FilmExport, LearnsOfFramesThatAreFoundMeanwhile) {
    folder.write("a-00002.png", "mine");
    const std::string pictures = folder.path("{name}-{frame:05}.png");
    state.frames = 2;
    state.player.all_frames = false;
    run_command(state, CommandId::export_film);
    const auto accept = std::get<FileBrowser>(state.dialogs.back()).accept;
    FilmForm& shown = *std::get<FileBrowser>(state.dialogs.back()).film;
    judge(shown, pictures);
    EXPECT_TRUE(test::contains(shown.judged.summary, "At least 2 pictures")) << shown.judged.summary;
    state.frames = 3;
    state.player.all_frames = true;
    judge(shown, pictures);
    EXPECT_EQ(shown.judged.summary, "3 pictures: a-00000.png to a-00002.png");
    state.dialogs.clear();
    accept(pictures, size);
    EXPECT_EQ(id_of(state.dialogs.back()), "replace");
}

TEST_F(FilmExport, SaysWhatToInstallAndOffersPictures) {
    setenv("PATH", "/nowhere", 1);
    EXPECT_TRUE(test::contains(judged("a.mp4").fault, "A film needs the program ffmpeg"));
    EXPECT_EQ(judged("{frame}.png").fault, "");
    run_command(state, CommandId::export_film);
    EXPECT_EQ(std::get<FileBrowser>(state.dialogs.back()).name, "{name}-{frame:05}.png");
}

TEST_F(FilmExport, AppearsWholeBesideTheLoop) {
    write_encoder("exec cat >\"$film\"");
    start_film(state, request("a.mkv"));
    ASSERT_TRUE(test::eventually([&] { return is_finished(); }));
    EXPECT_EQ(error(), "");
    EXPECT_EQ(state.messages.announcement, "Exported " + folder.path("a.mkv") + " (3 pictures, 40 x 30)");
    EXPECT_EQ(folder.read("a.mkv").size(), 3U * 40U * 30U * 3U);
}

TEST_F(FilmExport, SaysInOneMessageWhatWentWrong) {
    write_encoder("head -c 20 >\"$film\"\necho 'no such codec' >&2\nexit 3");
    start_film(state, request("a.mp4"));
    ASSERT_TRUE(test::eventually([&] { return is_finished(); }));
    EXPECT_TRUE(error().starts_with(folder.path("a.mp4") + ": cannot be written: ffmpeg has failed: no such codec")) << error();
    EXPECT_EQ(error().find("a.mp4", folder.path("a.mp4").size()), std::string::npos) << error();
    EXPECT_FALSE(folder.has("a.mp4"));

    write_encoder("exec cat >\"$film\"");
    state.dialogs.clear();
    folder.write("a.xyz", "1\n\nO 0 0 0\n1\n\nN 0 x 0\n1\n\nC 0 0 0\n");
    start_film(state, request("a.mp4"));
    ASSERT_TRUE(test::eventually([&] { return is_finished(); }));
    EXPECT_TRUE(test::contains(error(), path + ":6:5: found 'x'")) << error();
    EXPECT_TRUE(test::contains(error(), "1 of 3 pictures were done, and nothing is left of the film.")) << error();
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.xyz", "bin"}));
}

// The encoder takes no more than the first picture.
TEST_F(FilmExport, LeavesNothingWhenItIsCancelled) {
    write_encoder("head -c 270000 >\"$film\"\nexec sleep 60");
    FilmRequest large = request("a.mkv");
    large.options.size = {300, 300};
    start_film(state, large);
    ASSERT_TRUE(test::eventually([&] { return test::contains(state.filming->words().text, "picture 2 of 3"); }));
    run_command(state, CommandId::quit);
    EXPECT_FALSE(state.quits) << "it asks";
    EXPECT_EQ(id_of(state.dialogs.back()), "film-is-made");
    state.dialogs.clear();
    cancel_film(state);
    EXPECT_FALSE(state.filming);
    EXPECT_TRUE(test::contains(state.messages.announcement, "Cancelled: 1 of 3 pictures were done")) << state.messages.announcement;
    EXPECT_TRUE(test::eventually([&] {
        return folder.names() == std::vector<std::string>{"a.xyz", "bin"};
    })) << "an encoder that takes no more is not waited for";
}

// The encoder has all pictures, and is not done with them.
TEST_F(FilmExport, CanBeCancelledUntilItHasItsName) {
    write_encoder("cat >\"$film\"\necho >'" + folder.path("has-all") + "'\nexec sleep 60");
    start_film(state, request("a.mkv"));
    ASSERT_TRUE(test::eventually([&] { return folder.has("has-all"); }));
    cancel_film(state);
    EXPECT_EQ(state.messages.announcement, "Cancelled: 3 of 3 pictures were done, and nothing is left of the film");
    EXPECT_TRUE(test::eventually([&] { return folder.names() == std::vector<std::string>{"a.xyz", "bin", "has-all"}; }));
}

// What has ended is not cancelled any more.
TEST_F(FilmExport, CancelledAtItsEndIsExported) {
    write_encoder("exec cat >\"$film\"");
    start_film(state, request("a.mkv"));
    state.filming->job.wait();
    cancel_film(state);
    EXPECT_TRUE(is_finished());
    EXPECT_EQ(state.messages.announcement, "Exported " + folder.path("a.mkv") + " (3 pictures, 40 x 30)");
}

TEST_F(FilmExport, TheEndOfTheWindowEndsIt) {
    write_encoder("exec cat >\"$film\"");
    FilmRequest many = request("a.mkv", [](FilmForm& form) {
        form.chosen.takes_frames = false;
        form.chosen.turns = true;
        form.chosen.turntable = 100'000;
    });
    start_film(state, many);
    ASSERT_TRUE(test::eventually([&] { return test::contains(state.filming->words().text, "picture"); }));
    finish_writing(state, std::chrono::seconds(30));
    EXPECT_FALSE(state.filming);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.xyz", "bin"}));
}

TEST_F(FilmExport, AsksBeforeItReplacesPictures) {
    folder.write("a-00001.png", "mine");
    run_command(state, CommandId::export_film);
    const auto accept = std::get<FileBrowser>(state.dialogs.back()).accept;
    state.dialogs.clear();
    accept(folder.path("{name}-{frame:05}.png"), size);
    ASSERT_EQ(id_of(state.dialogs.back()), "replace");
    EXPECT_TRUE(test::contains(error(), "a-00001.png"));
    const auto answer = std::get<Question>(state.dialogs.back()).answer;
    state.dialogs.clear();
    answer(1);
    EXPECT_EQ(id_of(state.dialogs.back()), "film") << "another name can be chosen";
    EXPECT_FALSE(state.filming);
    state.dialogs.clear();
    answer(0);
    ASSERT_TRUE(test::eventually([&] { return is_finished(); }));
    EXPECT_TRUE(folder.read("a-00001.png").starts_with("\x89PNG"));
    EXPECT_TRUE(folder.has("a-00002.png"));
}

}  // namespace

}  // namespace sphereview

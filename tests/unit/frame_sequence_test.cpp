// The one camera of many frames is fitted once: later runs find it.
#include "app/frame_sequence.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "support/environment.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview {

#ifdef __linux__  // where the variable names the folder

namespace {

namespace fs = std::filesystem;

class KeptCamera : public testing::Test {
protected:
    KeptCamera() { write("5"); }

    // Of three frames, with what stands in the middle of the file; the same size, time and ends whatever that is.
    void write(const std::string& middle, const std::string& end = "H 3 0 0\n") {
        const std::string filler(5000, 'c');
        folder_.write("a.xyz", "1\n" + filler + "\nO 0 0 0\n1\n\nN 0 " + middle + " 0\n1\n" + filler + "\n" + end);
        fs::last_write_time(path_, time_);
    }

    RenderOptions options() const {
        RenderOptions options;
        options.scenes = {path_};
        options.frames.ranges = {{}};
        options.data.index_from = 0;
        return options;
    }

    Camera camera_by(const RenderOptions& options) const {
        Progress progress;
        FrameSequence sequence(path_, options, progress);
        sequence.prepare(progress);
        return sequence.load(sequence.shots().front()).scene.camera;
    }

    // Whether the frame in the middle is not read for the camera: what it holds makes no difference.
    bool is_kept(const RenderOptions& options) {
        write("5");
        const Camera camera = camera_by(options);
        write("9");
        const bool same = camera_by(options) == camera;
        write("5");
        return same;
    }

    std::size_t kept() const {
        const fs::path folder = fs::path(folder_.path("state")) / "sphereview" / "frames";
        if (!fs::is_directory(folder)) return 0;
        return static_cast<std::size_t>(std::ranges::count_if(fs::directory_iterator(folder), [](const fs::directory_entry& entry) {
            return entry.path().extension() == ".camera";
        }));
    }

    test::TemporaryFolder folder_;
    test::Variable state_{"XDG_STATE_HOME", folder_.path("state")};
    std::string path_ = folder_.path("a.xyz");
    fs::file_time_type time_ = fs::file_time_type::clock::now() - std::chrono::hours(1);
};

}  // namespace

TEST_F(KeptCamera, IsThatOfAllFramesWithoutReadingThem) {
    EXPECT_TRUE(is_kept(options()));
    EXPECT_EQ(kept(), 1U);
    // Other parts, and other pictures of the same frames.
    const Camera camera = camera_by(options());
    write("9");
    RenderOptions part = options();
    part.frames.part = RenderPart{2, 3};
    part.size = {30, 20};
    part.shading = Shading::studio;
    part.words = {"--frames", "all", "--size", "30x20"};
    EXPECT_EQ(camera_by(part), camera);
    EXPECT_EQ(kept(), 1U);
}

// What changes the camera asks anew.
TEST_F(KeptCamera, IsOfItsQuestionAlone) {
    const Camera camera = camera_by(options());
    std::vector<RenderOptions> others(6, options());
    others[0].frames.ranges = {{0, 2, 1}};
    others[1].fit.view = parse_view("top");
    others[2].fit.projection = Projection::orthographic;
    others[3].frames.turntable = 7;
    others[4].data.radius = 2.0;
    others[5].look.radius_scale = 3.0;
    others[5].words = {"--frames", "all", "--radius-scale", "3"};
    for (const RenderOptions& other : others) EXPECT_NE(camera_by(other), camera);
    EXPECT_EQ(kept(), 1 + others.size());
    for (const RenderOptions& other : others) EXPECT_TRUE(is_kept(other));
    EXPECT_EQ(camera_by(options()), camera);

    RenderOptions wordless = options();
    wordless.look.radius_scale = 3.0;
    EXPECT_FALSE(is_kept(wordless)) << "which look it is has no words";
    RenderOptions changed = options();
    Progress progress;
    FrameSequence sequence(path_, changed, progress);
    sequence.set_changes({.spheres = {{.number = 0, .radius = 20.0}}});
    sequence.prepare(progress);
    EXPECT_NE(sequence.load(sequence.shots().front()).scene.camera, camera);
}

TEST_F(KeptCamera, OfAnotherFileCountsForNothing) {
    const Camera camera = camera_by(options());
    write("5", "H 7 0 0\n");
    const Camera other = camera_by(options());
    EXPECT_NE(other, camera);
    time_ += std::chrono::minutes(1);
    write("9", "H 7 0 0\n");
    EXPECT_NE(camera_by(options()), other);
    EXPECT_EQ(kept(), 1U) << "the later one stays";
}

TEST_F(KeptCamera, IsNotKeptWhereThereIsNothingToSave) {
    RenderOptions no_index = options();
    no_index.data.index_from.reset();
    EXPECT_FALSE(is_kept(no_index));
    RenderOptions first = options();
    first.frames.fit_first = true;
    camera_by(first);
    RenderOptions one = options();
    one.frames.ranges = {{0, {}, 1, true}};
    one.frames.turntable = 9;
    camera_by(one);
    RenderOptions usual = options();
    usual.data.index_from = usual_index_from;
    EXPECT_FALSE(is_kept(usual));
    EXPECT_EQ(kept(), 0U);
}

// Its own picture says what is wrong with it; a film has none without.
TEST_F(KeptCamera, SeesWhatTheOthersHoldWhereAFrameIsWrong) {
    write("x");
    const Camera camera = camera_by(options());
    RenderOptions others = options();
    others.frames.ranges = {{0, {}, 1, true}, {2, {}, 1, true}};
    EXPECT_EQ(camera_by(others), camera);
    write("9");
    EXPECT_EQ(camera_by(options()), camera) << "kept";
    write("x");
    RenderOptions film = options();
    film.data.index_from.reset();
    film.film.movie = "a.mkv";
    EXPECT_THROW(camera_by(film), InputError);
}

// The radius of points is known before the first pass.
TEST_F(KeptCamera, IsKeptWhereAnotherFrameGivesTheRadius) {
    const auto frame = [](const std::string& atoms, int count) {
        return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n" + std::to_string(count) + "\nITEM: ATOMS id x y z\n" + atoms;
    };
    path_ = folder_.write("a.lammpstrj", frame("", 0) + frame("1 0 0 0\n2 3 0 0\n", 2) + frame("1 0 0 0\n2 5 0 0\n", 2));
    fs::last_write_time(path_, time_);
    const Camera camera = camera_by(options());
    EXPECT_EQ(camera_by(options()), camera);
    EXPECT_EQ(kept(), 1U);
}

#endif

}  // namespace sphereview

// View > Rays without a window: the rays, what hides them, which pixel is meant.
#include "viewer/rays_in_space.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "camera/beside.hpp"
#include "camera/camera_values.hpp"
#include "camera/navigation.hpp"
#include "exact/explain.hpp"
#include "support/eventually.hpp"
#include "support/spheres.hpp"
#include "viewer/hidden_parts.hpp"
#include "viewer/perform.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

constexpr PictureSize seen{300, 200};

struct Rays : testing::Test {
    Rays() : state(ViewOptions{}, ViewerSettings{}) {
        Scene scene = scene_of({{{0, 0, 300}, 60, {255, 0, 0}}, {{100, 0, 300}, 30, {0, 255, 0}}, {{0, 0, 500}, 80, {0, 0, 255}}});
        state.document = Document(scene);
        state.picture_size = seen;
        go_home(state);
    }

    // What the window's loop does until the view has arrived and all is made.
    void settle() {
        for (int i = 0; i < 3; ++i) fly_beside(state, {});
        if (state.flight) {
            const auto now = std::chrono::steady_clock::now();
            state.flight->advance(now);
            state.camera = state.flight->advance(now + CameraFlight::duration);
        }
        state.flight.reset();
        EXPECT_TRUE(test::eventually([&] {
            follow_rays(state);
            return !makes_rays(state);
        }));
    }
    std::int32_t visible(const Camera& camera, Pixel pixel) const {
        return explain_pixel(state.scene(), drawn_spheres(state.scene(), camera), camera, seen, pixel).visible();
    }

    ViewerState state;
};

// As if every pixel of the picture showed that sphere.
SeenTexels all_show(std::int32_t number) {
    return {1, seen.width, std::vector<std::int32_t>(static_cast<std::size_t>(seen.width * seen.height), number)};
}

}  // namespace

TEST_F(Rays, ChosenAreThoseOfTheSquaresAndNeverTooMany) {
    EXPECT_TRUE(pixels_of_rays(seen, {RaysShown::one, 8, 8}, 5).empty());
    const auto row = pixels_of_rays(seen, {RaysShown::row, 32, 8}, 77);
    ASSERT_EQ(row.size(), 10U);
    EXPECT_EQ(row[0], (Pixel{16, 77}));
    EXPECT_EQ(row[1], (Pixel{48, 77}));
    EXPECT_EQ(row.back(), (Pixel{299, 77})) << "the last square is cut off by the picture's edge";
    EXPECT_EQ(pixels_of_rays(seen, {RaysShown::all, 8, 32}, 0).size(), 70U);
    for (const PictureSize size : {seen, PictureSize{1, 1}, PictureSize{16384, 16384}, PictureSize{3, 5000}}) {
        for (const RaysShown shown : {RaysShown::row, RaysShown::all}) {
            const int every = least_every(size, shown);
            EXPECT_LE(pixels_of_rays(size, {shown, every, every}, 0).size(), most_rays);
            if (every > 1) {
                EXPECT_GT(pixels_of_rays(size, {shown, every / 2, every / 2}, 0).size(), most_rays);
            }
        }
        EXPECT_GE(usual_every(size, RaysShown::all), least_every(size, RaysShown::all));
    }
}

TEST_F(Rays, EndWhereTheExactHitIs) {
    const std::vector<Pixel> pixels = pixels_of_rays(seen, {RaysShown::all, 16, 16}, 0);
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        Camera camera = state.camera;
        camera.projection = projection;
        const std::vector<TracedRay> rays = trace_rays(state.scene(), camera, seen, pixels, 9.0);
        ASSERT_EQ(rays.size(), pixels.size());
        std::size_t hits = 0;
        for (const TracedRay& ray : rays) {
            const PixelExplanation e = explain_pixel(state.scene(), drawn_spheres(state.scene(), camera), camera, seen, ray.pixel);
            EXPECT_EQ(ray.visible, e.visible());
            EXPECT_NEAR(glm::distance(ray.from, e.origin), 0.0, 1e-9);
            if (ray.visible >= 0) {
                EXPECT_EQ(ray.to, e.hits.front().point);
                ++hits;
            } else {
                EXPECT_NEAR(depth_of(camera, ray.to), 9.0, 1e-9);
            }
        }
        EXPECT_GT(hits, 10U);
        EXPECT_LT(hits, rays.size());
    }
}

TEST_F(Rays, AreHiddenBehindWhatIsSeenAndNotBeforeIt) {
    const SeenTexels red = all_show(0);
    const HiddenParts hidden(state.scene(), state.camera, seen, red);
    const glm::dvec2 middle{150.0, 100.0};
    EXPECT_EQ(hit_depth(state.camera, seen, middle, state.scene().spheres[0]), 2.4);
    EXPECT_FALSE(hidden.hides(middle, 2.39));
    EXPECT_FALSE(hidden.hides(middle, 2.4)) << "a ray that ends on the sphere";
    EXPECT_TRUE(hidden.hides(middle, 2.41));
    EXPECT_FALSE(hidden.hides({-5.0, 100.0}, 9.0)) << "beside the picture";
    EXPECT_FALSE(hidden.hides({2.0, 100.0}, 9.0)) << "the ray through that place misses the sphere";

    const auto line = projected_line(state.camera, seen, {-200, 0, 400}, {200, 0, 400});
    ASSERT_TRUE(line);
    std::vector<bool> runs;
    double end = 0.0;
    hidden.for_each_run(*line, 1.0, [&](double begin, double to, bool is_hidden) {
        EXPECT_EQ(begin, end);
        end = to;
        runs.push_back(is_hidden);
    });
    EXPECT_EQ(end, 1.0);
    EXPECT_EQ(runs, (std::vector<bool>{false, true, false}));
}

TEST_F(Rays, AreAViewAndNoEdit) {
    const Camera eye = state.camera;
    const std::uint64_t revision = state.document.revision();
    run_command(state, CommandId::toggle_rays);
    EXPECT_TRUE(state.rays.on);
    EXPECT_EQ(state.rays.camera, eye);
    EXPECT_EQ(state.rays.screen_depth, 1.0);
    settle();
    EXPECT_NE(state.camera, eye);
    ASSERT_TRUE(state.pins.last) << "a ray is drawn at once";
    EXPECT_EQ(visible(eye, state.pins.last->pixel), 0);
    EXPECT_TRUE(place_of(state.camera, seen, eye.eye)) << "the eye is seen";
    EXPECT_TRUE(state.rays.picture.made());
    EXPECT_EQ(state.document.revision(), revision);
    EXPECT_FALSE(state.document.can_undo());
    run_command(state, CommandId::toggle_rays);
    EXPECT_FALSE(state.rays.on);
    settle();
    EXPECT_EQ(state.camera, eye) << "to the bit";
}

// The numbers in the camera panel are the drawn eye's, and who looks at it stays where he is.
TEST_F(Rays, AreSeenAsAWholeInAPictureOfAnotherSizeUntilTheViewIsMoved) {
    const glm::dvec3 pivot = state.pivot;
    show_rays(state);
    settle();
    const Camera wide = state.camera;
    state.picture_size = {150, 200};  // as the inspector leaves it
    settle();
    const Camera narrow = state.camera;
    EXPECT_NE(narrow, wide);
    EXPECT_EQ(narrow, *camera_beside(state.rays.camera, state.picture_size, state.rays.to_see, {}));
    state.camera = orbited(state.camera, state.pivot, 0.1, 0.0);
    const Camera moved = state.camera;
    state.picture_size = seen;
    settle();
    EXPECT_EQ(state.camera, moved);
    end_rays(state);
    EXPECT_EQ(state.pivot, pivot);
}

TEST_F(Rays, LetTheDrawnEyeBeEdited) {
    run_command(state, CommandId::toggle_rays);
    settle();
    const Camera beside = state.camera;
    const Camera eye = state.rays.camera;
    const Camera moved = with_eye(eye, eye.eye + glm::dvec3(3.0, 0.0, 0.0));
    perform(state, {EditScene{ChangeCamera{moved, true}, "Move the camera's eye"}});
    EXPECT_EQ(state.rays.camera, moved);
    EXPECT_EQ(state.camera, beside);
    run_command(state, CommandId::use_view_as_camera);
    EXPECT_EQ(state.scene().camera, moved);
    undo(state);
    EXPECT_EQ(state.rays.camera, eye);
    EXPECT_EQ(state.camera, beside);
    EXPECT_FALSE(state.document.is_changed());
}

TEST_F(Rays, FollowTheSceneTheRowAndTheChoice) {
    show_rays(state);
    settle();
    EXPECT_FALSE(state.rays.rays.made());
    state.rays.choice.shown = RaysShown::all;
    settle();
    ASSERT_TRUE(state.rays.rays.made());
    EXPECT_LE(state.rays.rays.made()->size(), most_rays);
    const auto on_red = [&] {
        return std::ranges::count_if(*state.rays.rays.made(), [](const TracedRay& ray) { return ray.visible == 0; });
    };
    EXPECT_GT(on_red(), 10);
    Sphere gone = state.scene().spheres[0];
    gone.hidden = true;
    state.document.apply(ChangeSpheres{{0}, {gone}}, "hide");
    settle();
    EXPECT_EQ(on_red(), 0);
    state.rays.choice.shown = RaysShown::row;
    state.pins.first = PinnedPixel{{10, 33}, seen};
    settle();
    for (const TracedRay& ray : *state.rays.rays.made()) EXPECT_EQ(ray.pixel.y, 33);
    state.rays.choice.in_row = 1;
    settle();
    EXPECT_EQ(state.rays.rays.made()->size(), 300U);
    state.rays.choice.shown = RaysShown::one;
    settle();
    EXPECT_FALSE(state.rays.rays.made());
}

TEST_F(Rays, APlaceMeansThePixelOfTheScreenOrTheRayToTheSphere) {
    const Camera eye = state.camera;
    show_rays(state);
    settle();
    const auto meant = [&](const glm::dvec3& point, bool on_screen = false) {
        const glm::dvec2 place = *place_of(state.camera, seen, point);
        const Pixel pixel{static_cast<int>(place.x), static_cast<int>(place.y)};
        return eye_pixel_at(state, place, visible(state.camera, pixel), on_screen);
    };
    EXPECT_EQ(meant(point_at(eye, seen, {20.5, 30.5}, 1.0)), (PinnedPixel{{20, 30}, seen}));
    EXPECT_EQ(meant(point_at(eye, seen, {20.5, 30.5}, 1.0), true), (PinnedPixel{{20, 30}, seen}));
    // The right side of the green sphere, which the view sees and the eye does not: the ray that leads there, and ends before.
    const glm::dvec3 toward = glm::normalize(state.camera.eye - glm::dvec3(100, 0, 300));
    const glm::dvec3 seen_point = glm::dvec3(100, 0, 300) + 30.0 * toward;
    const glm::dvec2 pixel = *place_of(eye, seen, seen_point);
    EXPECT_EQ(meant(seen_point), (PinnedPixel{{static_cast<int>(pixel.x), static_cast<int>(pixel.y)}, seen}));
    EXPECT_FALSE(meant(seen_point, true));
    EXPECT_FALSE(eye_pixel_at(state, {1.0, 1.0}, visible_background)) << "nothing is there";
}

TEST_F(Rays, AreExplainedForTheEyeAndLetGoWithAnotherScene) {
    const Camera eye = state.camera;
    show_rays(state);
    settle();
    EXPECT_EQ(state.inspected_camera(), eye);
    EXPECT_TRUE(state.has_pins());
    end_rays(state);
    settle();
    EXPECT_EQ(state.inspected_camera(), state.camera);
    show_rays(state);
    perform(state, {PinPixel{{7, 8}, {100, 100}}});
    EXPECT_FALSE(state.rays.on) << "of a picture that was compared, seen by the scene's own camera";
}

TEST_F(Rays, OfAViewWhoseScreenLiesInTheSceneHaveItDrawnBefore) {
    state.camera = {{0, 0, 200}, {0, 0, 300}, {50, 0, 0}, {0, 50, 0}};
    show_rays(state);
    EXPECT_LT(state.rays.screen_depth, 0.4);
}

TEST_F(Rays, ASceneWithNothingToSeeHasThemAllTheSame) {
    state.document = Document(Scene{});
    show_rays(state);
    settle();
    EXPECT_TRUE(state.rays.on);
    EXPECT_GT(state.rays.far_depth, 1.0);
    EXPECT_FALSE(camera_fault(state.camera));
}

}  // namespace sphereview

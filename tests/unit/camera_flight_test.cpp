#include "viewer/camera_flight.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "camera/fit.hpp"
#include "support/spheres.hpp"
#include "viewer/perform.hpp"

namespace sphereview {
namespace {

using std::chrono::milliseconds;

const CameraFlight::Time start{std::chrono::hours(1)};
const glm::dvec3 pivot{10.0, 20.0, 30.0};

// From that side of the pivot, so far away.
Camera camera_from(double azimuth, double elevation, double distance) {
    const auto [right, up, ahead] = axes_from(azimuth, elevation);
    const glm::dvec3 eye = pivot - distance * ahead;
    return {eye, eye + 100.0 * ahead, 50.0 * right, 50.0 * up};
}

Scene one_sphere() {
    Scene scene = scene_of({{pivot, 5.0, {}, false}});
    return scene;
}

struct State : ViewerState {
    State() : ViewerState({}, {}) {
        document = Document(one_sphere());
        go_home(*this);
    }
};

}  // namespace

TEST(CameraFlight, ArrivesToTheBitAndInTime) {
    const Camera from = camera_from(10.0, 0.0, 300.0);
    const Camera to = camera_from(123.0, 45.0, 80.0);
    CameraFlight flight(from, to, pivot);
    EXPECT_LT(glm::distance(flight.advance(start).eye, from.eye), 1e-9);
    EXPECT_FALSE(flight.has_arrived());
    EXPECT_NE(flight.advance(start + milliseconds(299)), to);
    EXPECT_FALSE(flight.has_arrived());
    EXPECT_EQ(flight.advance(start + milliseconds(300)), to);
    EXPECT_TRUE(flight.has_arrived());
    EXPECT_EQ(flight.advance(start + milliseconds(5000)), to);
}

TEST(CameraFlight, KeepsLookingAtThePivotWithoutAFault) {
    for (const double azimuth : {0.0, 90.0, 179.0, 180.0, -90.0}) {
        CameraFlight flight(camera_from(0.0, 0.0, 300.0), camera_from(azimuth, 90.0, 80.0), pivot);
        double last = 301.0;
        for (int ms = 0; ms < 300; ms += 10) {
            const Camera camera = flight.advance(start + milliseconds(ms));
            ASSERT_FALSE(camera_fault(camera)) << azimuth << " " << ms;
            const double distance = glm::distance(camera.eye, pivot);
            EXPECT_LT(distance, last);
            last = distance;
            const glm::dvec3 ahead = glm::normalize(camera.center - camera.eye);
            EXPECT_LT(glm::distance(camera.eye + distance * ahead, pivot), 1e-9);
        }
    }
}

TEST(CameraFlight, NeverPassesThroughAFault) {
    const Camera plain;
    Camera mirrored;
    mirrored.right = -mirrored.right;
    Camera far{{1e308, -1e308, 0.0}, {1e308, -1e308, 1e300}, {1e300, 0.0, 0.0}, {0.0, 1e300, 0.0}};
    Camera other_mirrored = camera_from(70.0, 30.0, 10.0);
    other_mirrored.right = -other_mirrored.right;
    for (const auto& [from, to] : {std::pair{plain, mirrored}, {plain, far}, {far, plain}, {mirrored, other_mirrored}}) {
        CameraFlight flight(from, to, pivot);
        for (int ms = 0; ms <= 300; ms += 10) ASSERT_FALSE(camera_fault(flight.advance(start + milliseconds(ms)))) << ms;
        EXPECT_EQ(flight.last(), to);
    }
}

TEST(FitInTheViewer, FliesToTheFittedCameraAndThenRests) {
    State state;
    run_command(state, CommandId::view_iso);
    EXPECT_EQ(state.camera, Camera());
    EXPECT_TRUE(fly_on(state, start));
    EXPECT_TRUE(fly_on(state, start + milliseconds(100)));
    EXPECT_NE(state.camera, Camera());
    EXPECT_TRUE(fly_on(state, start + milliseconds(310)));
    EXPECT_EQ(state.camera, fitted(state.scene(), isometric_axes()));
    EXPECT_EQ(state.pivot, pivot);
    EXPECT_FALSE(fly_on(state, start + milliseconds(320)));
    // From there, and not from the front.
    state.camera.eye += 1000.0;
    state.camera.center += 1000.0;
    run_command(state, CommandId::fit_all);
    fly_on(state, start);
    fly_on(state, start + milliseconds(300));
    EXPECT_LT(glm::distance(state.camera.eye, fitted(state.scene(), isometric_axes())->eye), 1e-9);
}

TEST(FitInTheViewer, EndsWhereSomethingElseMovesTheView) {
    State state;
    run_command(state, CommandId::view_right);
    fly_on(state, start);
    fly_on(state, start + milliseconds(100));
    go_home(state);
    EXPECT_FALSE(fly_on(state, start + milliseconds(200)));
    EXPECT_FALSE(state.flight);
    EXPECT_EQ(state.camera, state.scene().camera);
}

TEST(FitInTheViewer, StaysIfThereIsNothingToSee) {
    State state;
    state.document = Document(Scene());
    run_command(state, CommandId::fit_all);
    EXPECT_FALSE(state.flight);
    EXPECT_FALSE(fly_on(state, start));
    EXPECT_EQ(state.camera, Camera());
}

}  // namespace sphereview

// The mouse in the picture, without a window.
#include "viewer/mouse_control.hpp"
#include "unit/projection.hpp"

#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>

#include "base/text.hpp"

namespace sphereview {

namespace {

// A sphere straight ahead; the pointer picks it wherever it is less than 150 pixels from the middle.
struct Hand : testing::Test {
    Hand() {
        scene.spheres = {Sphere{.center = {0, 0, 300}, .radius = 60, .color = {255, 0, 0}}};
        mouse.place = {520, 490};
        mouse.available = true;
    }

    PictureConsequences redraw() {
        actions.clear();
        const PictureState state{scene,
                                 selection,
                                 camera,
                                 size,
                                 {0, 0, 300},
                                 [&](glm::dvec2 at) { return glm::distance(at, glm::dvec2(500, 500)) < 150 ? 0 : -1; },
                                 [&](Pixel low, Pixel high, bool toggles) {
                                     boxes.push_back({low.x, low.y, high.x, high.y});
                                     if (toggles) {
                                         selection.toggle_all(in_box);
                                     } else {
                                         selection.set(in_box);
                                     }
                                 },
                                 {},
                                 trackball,
                                 false,
                                 turns_about,
                                 [this](glm::dvec2) { return covered; }};
        const PictureConsequences done = control.redraw(mouse, state, gesture, actions);
        mouse.pressed = {};
        mouse.released = {};
        mouse.wheel = 0.0;
        mouse.double_clicked = false;
        mouse.cancelled = false;
        for (const Action& action : actions) {
            if (const auto* edit = std::get_if<EditScene>(&action)) scene.spheres = std::get<ChangeSpheres>(edit->edit).spheres;
            if (const auto* select = std::get_if<SelectSpheres>(&action)) selection = select->selection;
        }
        if (done.camera) camera = *done.camera;
        return done;
    }
    void press(std::size_t button = 0) {
        mouse.pressed[button] = true;
        redraw();
    }
    void drag_to(glm::dvec2 place) {
        mouse.place = place;
        redraw();
    }
    void cancel() {
        mouse.cancelled = true;
        redraw();
    }
    void press_at(glm::dvec2 place) {
        mouse.place = place;
        press();
    }
    void expect_shown(const glm::dvec3& point, glm::dvec2 place, double pixels = 1e-6) const {
        const auto seen = project(camera, size, point);
        ASSERT_TRUE(seen);
        EXPECT_LT(glm::distance(*seen, place), pixels);
    }
    void release(std::size_t button = 0) {
        mouse.released[button] = true;
        redraw();
    }
    std::uint64_t gesture_of_action() const { return std::get<EditScene>(actions.at(0)).gesture; }
    bool undoes() const {
        return actions.size() == 1 && std::holds_alternative<RunCommand>(actions[0]) &&
               std::get<RunCommand>(actions[0]).command == CommandId::undo;
    }

    Scene scene;
    Selection selection;
    Camera camera;
    PictureSize size{1000, 1000};
    std::uint64_t gesture = 0;
    bool trackball = false;
    std::optional<glm::dvec3> turns_about;
    bool covered = false;  // by something that takes clicks
    std::vector<Action> actions;
    std::vector<std::uint32_t> in_box;      // in any box
    std::vector<std::array<int, 4>> boxes;  // asked for
    MouseControl control;
    PictureMouse mouse;
};

}  // namespace

TEST_F(Hand, ATrackballPassesThePoleAndATurntableDoesNot) {
    for (const bool ball : {false, true}) {
        camera = {};
        trackball = ball;
        press_at({500, 100});
        for (int y = 200; y <= 1100; y += 100) drag_to({500, y});
        release();
        EXPECT_EQ(camera.up.y < 0.0, ball) << "turned by a whole side of the picture";
    }
}

TEST_F(Hand, ThePointThatWasGrabbedStaysUnderThePointer) {
    selection.set_only(0);
    const glm::dvec3 center = scene.spheres[0].center;
    press();
    // The nearer point of the sphere on the pointer's ray.
    glm::dvec3 ray = glm::normalize(point_at(camera, size, mouse.place, 1.0));
    const double along = glm::dot(center, ray);
    const glm::dvec3 grabbed = ray * (along - std::sqrt(3600.0 - (glm::dot(center, center) - along * along)));
    for (const glm::dvec2 to : {glm::dvec2(540, 470), glm::dvec2(100, 900), glm::dvec2(990, 3)}) {
        drag_to(to);
        expect_shown(grabbed + scene.spheres[0].center - center, to, 1.0);
        EXPECT_EQ(gesture_of_action(), gesture) << "one step";
    }
    EXPECT_EQ(gesture, 1U);
    release();
    EXPECT_FALSE(control.is_dragging());
}

TEST_F(Hand, ADragLeavesFewDigitsAndNothingElse) {
    scene.spheres[0].center = {0.1, -0.7, 300.25};
    scene.spheres.push_back({.center = {1.0 / 3.0, 0, 400}, .radius = 1, .color = {}});
    const std::vector<Sphere> before = scene.spheres;
    selection.set({0});
    press();
    std::vector<Sphere> dragged;
    for (const glm::dvec2 to : {glm::dvec2(543, 471), glm::dvec2(777, 123), glm::dvec2(520, 800)}) {
        drag_to(to);
        dragged = scene.spheres;
        ASSERT_EQ(dragged.size(), 1U) << "of the edit";
        EXPECT_EQ(dragged[0].center.z, 300.25) << "to the bit: no depth was dragged";
        for (const double value : {dragged[0].center.x, dragged[0].center.y})
            EXPECT_LE(shortest(value).size(), 7U) << shortest(value);
        scene.spheres = before;
    }
    EXPECT_EQ(dragged[0].center.x, 0.1) << "back is back to the bit";
    release();
}

TEST_F(Hand, EscapeTakesAMoveBackAndOnlyThat) {
    selection.set_only(0);
    press();
    drag_to(mouse.place + glm::dvec2(50, 0));
    cancel();
    EXPECT_TRUE(undoes());
    EXPECT_FALSE(control.is_dragging());

    press();
    cancel();
    EXPECT_TRUE(actions.empty()) << "nothing had moved";

    // A drag that moved nothing, because the sphere has gone from the selection: what was done before it stays.
    press();
    selection.clear();
    drag_to(mouse.place + glm::dvec2(50, 0));
    cancel();
    EXPECT_TRUE(actions.empty());
}

TEST_F(Hand, APictureThatChangesUnderAPointerThatRestsMovesNothing) {
    selection.set_only(0);
    const std::vector<Sphere> before = scene.spheres;
    const Camera camera_before = camera;
    // The picture's corner moves by so much in the window, and what the pointer is over in the picture with it.
    const auto change_picture = [&](glm::dvec2 by, PictureSize to) {
        mouse.corner += by;
        mouse.place -= by;
        size = to;
        redraw();
    };
    for (const glm::dvec2 place : {glm::dvec2(520, 490), glm::dvec2(10, 10)}) {  // a move of the sphere, and an orbit
        mouse.corner = {};
        size = {1000, 1000};
        press_at(place);
        change_picture({300, 40}, {700, 900});
        EXPECT_TRUE(actions.empty());
        EXPECT_FALSE(control.is_dragging());
        change_picture({-200, 0}, {900, 900});
        mouse.released[0] = true;
        redraw();
        EXPECT_EQ(scene.spheres, before);
        EXPECT_EQ(camera, camera_before);
    }
    // A drag that goes on is by as much as the pointer moves on the screen.
    selection.set_only(0);
    mouse.corner = {};
    size = {1000, 1000};
    press_at({520, 490});
    drag_to({560, 490});
    const std::vector<Sphere> moved = scene.spheres;
    EXPECT_NE(moved, before);
    change_picture({300, 0}, {1000, 1000});
    EXPECT_EQ(scene.spheres, moved);
    drag_to(mouse.place + glm::dvec2(40, 0));
    EXPECT_NEAR(scene.spheres[0].center.x, 2.0 * moved[0].center.x, 1.0);
    cancel();
    EXPECT_TRUE(undoes()) << "still one step";
}

TEST_F(Hand, AClickSelectsAndADragDoesNot) {
    press();
    release();
    EXPECT_TRUE(selection.contains(0));
    EXPECT_TRUE(std::get<SelectSpheres>(actions.at(0)).shows_row) << "in the list";
    press_at({10, 10});
    mouse.place = {300, 300};
    EXPECT_TRUE(redraw().camera) << "an orbit";
    release();
    EXPECT_TRUE(selection.contains(0));
    press_at({10, 10});
    release();
    EXPECT_TRUE(selection.empty());
}

TEST_F(Hand, AClickOnWhatCoversTheSphereSelectsNothingAndIsReported) {
    covered = true;
    press();
    mouse.released[0] = true;
    EXPECT_TRUE(redraw().clicked);
    EXPECT_TRUE(selection.empty());
    selection.set_only(0);
    press_at({900, 900});
    release();
    EXPECT_FALSE(selection.empty()) << "nor does it select none";
    covered = false;
    press_at({900, 900});
    release();
    EXPECT_TRUE(selection.empty());
}

TEST_F(Hand, TurnsAboutWhatIsUnderThePointerOrTheMiddleOfWhatIsSeen) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        camera = with_projection(Camera{}, projection, 3.0);
        press_at({520, 490});
        EXPECT_FALSE(control.turns_about()) << "it may become a click";
        drag_to({700, 560});
        const auto point = control.turns_about();
        ASSERT_TRUE(point);
        EXPECT_NEAR(glm::distance(*point, scene.spheres[0].center), 60.0, 1e-9) << "on the sphere";
        for (const glm::dvec2 to : {glm::dvec2(800, 300), glm::dvec2(20, 500)}) {
            drag_to(to);
            expect_shown(*point, {520, 490});
            EXPECT_EQ(control.turns_about(), point);
        }
        release();
        EXPECT_FALSE(control.turns_about());

        camera = with_projection(Camera{}, projection, 3.0);
        press_at({10, 10});
        drag_to({210, 10});
        // In the middle of the side of the sphere that is seen.
        const auto middle = control.turns_about();
        ASSERT_TRUE(middle);
        EXPECT_TRUE(middle->z >= 240.0 && middle->z < 300.0) << middle->z;
        expect_shown(*middle, {500, 500});
        release();
    }
}

TEST_F(Hand, TurnsBesideAllSpheresAboutWhatItIsTold) {
    turns_about = glm::dvec3(10, 20, 150);
    press_at({100, 900});
    drag_to({160, 900});
    EXPECT_EQ(control.turns_about(), turns_about);
    release();
    press_at({500, 500});
    drag_to({560, 500});
    EXPECT_NE(control.turns_about(), turns_about) << "over a sphere, about that";
}

TEST_F(Hand, ZoomingOutEndsWhereTheSceneIsSmall) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        camera = with_projection(Camera{}, projection, 3.0);
        for (int i = 0; i < 200; ++i) {
            mouse.wheel = -1.0;
            redraw();
        }
        const auto low = place_of(camera, size, {-100, 0, 200});
        const auto high = place_of(camera, size, {100, 0, 200});
        ASSERT_TRUE(low && high);
        EXPECT_GT(glm::distance(*low, *high), 0.25 * size.width * 0.99);
        EXPECT_LT(glm::distance(*low, *high), 0.25 * size.width / 0.84);
        const Camera far = camera;
        mouse.wheel = 1.0;
        redraw();
        EXPECT_NE(camera, far) << "and back";
    }
}

TEST_F(Hand, DoesTheSameWhateverTheScreensSize) {
    selection.set_only(0);
    const std::vector<Sphere> before = scene.spheres;
    std::vector<glm::dvec3> places;
    std::vector<double> depths;
    for (const int exponent : exponents_of_screens) {
        camera = camera_of_screen(exponent);
        press();
        drag_to({777, 123});
        places.push_back(scene.spheres.at(0).center);
        release();
        scene.spheres = before;
        mouse.place = {520, 490};
        for (int i = 0; i < 200; ++i) {
            mouse.wheel = -1.0;
            redraw();
        }
        depths.push_back(glm::distance(camera.eye, before[0].center));
        EXPECT_EQ(places.back(), places.front()) << exponent;
        EXPECT_NEAR(depths.back(), depths.front(), 1e-6 * depths.front()) << exponent;
    }
}

TEST_F(Hand, TellsWhetherItMovesTheView) {
    press();
    EXPECT_FALSE(control.moves_camera());  // it may become a click
    drag_to(mouse.place + glm::dvec2(60, 0));
    EXPECT_TRUE(control.moves_camera());
    release();
    EXPECT_FALSE(control.moves_camera());
    selection.set_only(0);
    press_at({520, 490});
    drag_to(mouse.place + glm::dvec2(60, 0));
    EXPECT_TRUE(control.is_dragging());
    EXPECT_FALSE(control.moves_camera());  // but the sphere
}

TEST_F(Hand, TheWheelKeepsWhatIsUnderThePointer) {
    mouse.place = {800, 300};
    const glm::dvec3 point = point_at(camera, size, mouse.place, depth_of(camera, {0, 0, 300}));
    mouse.wheel = 2.0;
    EXPECT_TRUE(redraw().camera);
    expect_shown(point, {800, 300});
}

TEST_F(Hand, CtrlAndWheelIsOneStepOverOneSphere) {
    selection.set_only(0);
    mouse.control = true;
    mouse.wheel = 1.0;
    redraw();
    const std::uint64_t first = gesture_of_action();
    mouse.wheel = 1.0;
    redraw();
    EXPECT_EQ(gesture_of_action(), first);
    EXPECT_EQ(scene.spheres[0].radius, 67.416);
    mouse.wheel = 1.0;
    redraw();
    EXPECT_EQ(scene.spheres[0].radius, 71.461) << "few digits";
    ++gesture;  // something else was done between
    mouse.wheel = -1.0;
    redraw();
    EXPECT_NE(gesture_of_action(), first);
}

TEST_F(Hand, ControlAndADragSelectsWhatTheBoxShows) {
    const Camera before = camera;
    scene.spheres.resize(6);
    mouse.control = true;
    const auto drag = [&](glm::dvec2 from, glm::dvec2 to) {
        press_at(from);
        EXPECT_FALSE(control.box());
        drag_to(to);
        const bool drawn = control.box().has_value();
        release();
        EXPECT_FALSE(control.box());
        return drawn;
    };
    in_box = {1, 4};
    EXPECT_TRUE(drag({700, 20}, {300.5, 800}));
    EXPECT_EQ(boxes, (std::vector<std::array<int, 4>>{{300, 20, 700, 800}}));
    EXPECT_EQ(selection.numbers(), (std::vector<std::uint32_t>{1, 4}));
    mouse.shift = true;
    in_box = {0, 1};
    drag({500, 500}, {2000, -30});  // begins on a sphere, ends beyond the picture
    EXPECT_EQ(boxes.back(), (std::array<int, 4>{500, 0, 999, 500}));
    EXPECT_EQ(selection.numbers(), (std::vector<std::uint32_t>{0, 1, 4}));
    drag({10, 10}, {600, 600});
    EXPECT_EQ(selection.numbers(), std::vector<std::uint32_t>{4}) << "all were selected: they leave";
    mouse.shift = false;
    in_box = {};
    drag({10, 10}, {60, 60});
    EXPECT_TRUE(selection.empty());
    EXPECT_EQ(camera, before);

    // Escape leaves the selection as it was; a click is no box.
    in_box = {2};
    press_at({10, 10});
    drag_to({600, 600});
    cancel();
    release();
    EXPECT_TRUE(selection.empty());
    press_at({520, 490});
    release();
    EXPECT_EQ(selection.numbers(), std::vector<std::uint32_t>{0});
    EXPECT_EQ(boxes.size(), 4U);
}

}  // namespace sphereview

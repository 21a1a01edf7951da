// The picture of the window of many spheres: while few of them are edited, for which nothing is built anew, and while the camera
// moves.
#include <gtest/gtest.h>

#include "camera/navigation.hpp"
#include "gl/live_export.hpp"

namespace sphereview::test {
namespace {

constexpr TextureBounds only_2d = {.in_buffer = 1, .side = 2048};

using LiveOrbit = LiveAndExported;

class LiveEdit : public LiveAndExported {
protected:
    static Scene many_spheres() {
        Scene scene = colorful_scene(9'000);
        for (Sphere& sphere : scene.spheres) sphere.radius *= 0.3;
        return scene;
    }

    void expect_shown(LivePicture& picture, const Document& document, int step = 1) {
        test::expect_shown(picture, document, view_, step, exported(document.scene(), view_));
    }

    // Decided, and with every sphere under its present number.
    void expect_exact(LivePicture& picture, const Document& document) {
        picture.update(document, view_, 1);
        expect_picked(picture, document, view_, 3);
    }

    // As a picture that has never seen another scene, with the same outlines.
    void expect_marked(LivePicture& picture, const Document& document, const Selection& selection) {
        LivePicture anew;
        anew.update(document, view_, 1);
        const Highlights highlights{&selection, {}, 2.0F};
        EXPECT_TRUE(
            same(drawn_into_window(picture, document, view_, highlights), drawn_into_window(anew, document, view_, highlights)));
    }

    View view_{Camera(), {203, 101}};
};

TEST_P(LiveEdit, FollowsADragThroughManySpheres) {
    for (const TextureBounds& bounds : {TextureBounds{}, only_2d}) {
        Document document(many_spheres());
        LivePicture picture("", bounds);
        shown(picture, document, view_);
        EXPECT_EQ(picture.storage(), bounds.in_buffer == 1 ? "2D textures" : "buffer textures");
        const std::uint64_t builds = picture.builds();
        Sphere sphere = document.scene().spheres[4];
        sphere.radius = 9.0;
        for (int i = 0; i < 8; ++i) {
            sphere.center = {-90.0 + 25.0 * i, 10.0 * i - 40.0, 150.0 + i};
            sphere.color.r = static_cast<std::uint8_t>(30 * i);
            document.apply(change(4, sphere), "drag", 1);
            expect_shown(picture, document, i % 3 == 2 ? 4 : 1);
        }
        expect_exact(picture, document);
        document.undo();
        expect_shown(picture, document);
        expect_exact(picture, document);
        EXPECT_EQ(picture.builds(), builds);
    }
}

TEST_P(LiveEdit, FollowsATwinThatComesAndGoesInTheUniformBuffer) {
    Document document(colorful_scene(3));
    LivePicture picture;
    shown(picture, document, view_);
    EXPECT_EQ(picture.storage(), "uniform buffer");
    document.apply(InsertSpheres{{3}, {{document.scene().spheres[1], ""}}}, "Duplicate");
    picture.update(document, view_, 1);
    expect_exact(picture, document);
    document.undo();
    picture.update(document, view_, 1);
    expect_exact(picture, document);
}

TEST_P(LiveEdit, FollowsWhatComesGoesAndIsHidden) {
    for (const TextureBounds& bounds : {TextureBounds{}, only_2d}) {
        Document document(many_spheres());
        LivePicture picture("", bounds);
        Selection selection;
        selection.set({0, 3, 6});
        shown(picture, document, view_, 1, {&selection, {}, 2.0F});
        const std::uint64_t builds = picture.builds();
        const Sphere large{{5, -5, 160}, 12.0, {250, 128, 3}, false};
        Sphere hidden = document.scene().spheres[0];
        hidden.hidden = true;
        const std::vector<Edit> edits = {
            InsertSpheres{{0}, {{large, "first"}}},
            InsertSpheres{{9'001}, {{{{60, 20, 150}, 8.0, {1, 2, 250}, false}, ""}}},
            change(1, hidden),
            RemoveSpheres{{3, 4, 7}},
            InsertSpheres{{2, 5'000},
                          {{{{-60, 20, 150}, 8.0, {1, 200, 2}, false}, ""}, {{{-50, 24, 140}, 8.0, {90, 0, 2}, false}, ""}}},
            RemoveSpheres{{0}},
        };
        const auto expect_all = [&] {
            expect_shown(picture, document);
            selection.set({0, 1, 2, 5'000});
            expect_marked(picture, document, selection);
        };
        for (const Edit& edit : edits) {
            document.apply(edit, "edit");
            expect_all();
        }
        expect_exact(picture, document);
        while (document.can_undo()) {
            document.undo();
            expect_all();
        }
        expect_exact(picture, document);
        EXPECT_EQ(picture.builds(), builds);

        // Elsewhere the gaps are closed.
        view_.camera.eye.x = 3.0;
        expect_exact(picture, document);
        EXPECT_EQ(picture.builds(), builds + 1);
        view_.camera.eye.x = 0.0;
    }
}

TEST_P(LiveEdit, ColoursOfNumbersFollowThem) {
    Document document(many_spheres());
    LivePicture picture;
    picture.update(document, view_, 1, Shading::id);
    document.apply(RemoveSpheres{{1}}, "delete");
    picture.update(document, view_, 1, Shading::id);
    LivePicture anew;
    anew.update(document, view_, 1, Shading::id);
    EXPECT_TRUE(same(drawn_into_window(picture, document, view_, {}), drawn_into_window(anew, document, view_, {})));
    EXPECT_EQ(picture.builds(), 1U);
}

// So many that a coarse grid has lists of its own.
TEST_P(LiveOrbit, MovesAboutManySpheres) {
    Scene scene = colorful_scene(33'000);
    for (Sphere& sphere : scene.spheres) sphere.radius *= 0.2;
    const Document document(scene);
    LivePicture picture;
    View view{scene.camera, {203, 101}};
    for (int turn = 0; turn < 4; ++turn) {
        view.camera = orbited(view.camera, {0.0, 0.0, 250.0}, 0.2, 0.05);
        const Image expected = exported(scene, view);
        for (const int step : {8, 2, 1}) {
            SCOPED_TRACE(std::to_string(turn) + ", step " + std::to_string(step));
            expect_shown(picture, document, view, step, expected);
            if (turn % 2 == 0 && step == 2) break;  // on to the next view, not refined
        }
    }
    EXPECT_EQ(picture.step(), 1);
    EXPECT_FALSE(picture.update(document, view, 8));  // it has better
    expect_picked(picture, document, view, 4);
}

TEST_P(LiveOrbit, FollowsColoursAndPicksWhileItMoves) {
    Document document(colorful_scene(33'000));
    LivePicture picture;
    View view{document.scene().camera, {120, 90}};
    shown(picture, document, view, 8);
    Selection all;
    all.set({0, 1, 3});
    for (int turn = 0; turn < 3; ++turn) {
        view.camera = orbited(view.camera, {0.0, 0.0, 250.0}, 0.1, 0.0);
        Sphere sphere = document.scene().spheres[0];
        sphere.color = {static_cast<std::uint8_t>(turn), 200, 7};
        document.apply(change(0, sphere), "colour");
        LivePicture anew;
        EXPECT_TRUE(same(shown(picture, document, view, 8, {&all, {}, 2.0F}), shown(anew, document, view, 8, {&all, {}, 2.0F})));
        expect_picked(picture, document, view, 9);
    }
}

INSTANTIATE_TEST_SUITE_P(Contexts, LiveOrbit, testing::ValuesIn(context_kinds()), testing::PrintToStringParamName());
INSTANTIATE_TEST_SUITE_P(Contexts, LiveEdit, testing::ValuesIn(context_kinds()), testing::PrintToStringParamName());

}  // namespace
}  // namespace sphereview::test

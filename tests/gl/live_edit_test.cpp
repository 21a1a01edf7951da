// The picture of the window while few of many spheres are edited: what it shows, and that nothing is built anew for it.
#include <gtest/gtest.h>

#include "gl/live_export.hpp"

namespace sphereview::test {
namespace {

constexpr TextureBounds only_2d = {.in_buffer = 1, .side = 2048};

class LiveEdit : public LiveAndExported {
protected:
    static Scene many_spheres() {
        Scene scene = colorful_scene(9'000);
        for (Sphere& sphere : scene.spheres) sphere.radius *= 0.3;
        return scene;
    }

    // Of a doubtful pixel a window shows a guess, which may be another with other lists.
    void expect_shown(LivePicture& picture, const Document& document, int step = 1) {
        const Scene& scene = document.scene();
        const Image expected = colored(scene, view_, numbers(scene, view_));
        const DrawnSpheres drawn = drawn_spheres(scene, view_.camera);
        const PixelGrid grid{view_.size, step};
        const Image image = shown(picture, document, view_, step);
        for (int y = 0; y < view_.size.height; ++y) {
            for (int x = 0; x < view_.size.width; ++x) {
                const Pixel traced{grid.traced_column(x / step), grid.traced_row(y / step)};
                if (at(image, x, y) == at(expected, traced.x, traced.y)) continue;
                ASSERT_NE(decision_level(scene, drawn, view_.camera, view_.size, traced), DecisionLevel::in_float) << x << "," << y;
            }
        }
    }

    // Decided, and with every sphere under its present number.
    void expect_exact(LivePicture& picture, const Document& document) {
        picture.update(document, view_, 1);
        const DrawnSpheres drawn = drawn_spheres(document.scene(), view_.camera);
        const Resolver resolver(document.scene(), drawn, view_.camera, view_.size, nullptr);
        DecisionLevel level{};
        for (int y = 0; y < view_.size.height; y += 3) {
            for (int x = y % 5; x < view_.size.width; x += 5) {
                ASSERT_EQ(picture.pick(document, {x, y}), resolver.resolve({x, y}, level)) << x << "," << y;
            }
        }
    }

    // As a picture that has never seen another scene, with the same outlines.
    void expect_marked(LivePicture& picture, const Document& document, const Selection& selection) {
        LivePicture anew;
        anew.update(document, view_, 1);
        const Highlights highlights{&selection, {}, 2.0F};
        EXPECT_TRUE(same(in_window(picture, document, highlights), in_window(anew, document, highlights)));
    }

    Image in_window(LivePicture& picture, const Document& document, const Highlights& highlights) const {
        const WindowTarget window(view_.size.width, view_.size.height);
        picture.show({0, 0, view_.size.width, view_.size.height}, document.scene().background, highlights);
        return window.pixels();
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
    EXPECT_TRUE(same(in_window(picture, document, {}), in_window(anew, document, {})));
    EXPECT_EQ(picture.builds(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Contexts, LiveEdit, testing::ValuesIn(context_kinds()), [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace sphereview::test

// The picture of the window: what it shows, what it marks, and when it is traced again.
#include "gpu/live_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "exact/resolve.hpp"
#include "gl/live_export.hpp"

namespace sphereview::test {
namespace {

using LivePictureTest = LiveAndExported;

constexpr std::array<int, 4> steps = {8, 4, 2, 1};

TEST_P(LivePictureTest, ShowsWhatAnExportShowsAtEverySize) {
    Scene scene = colorful_scene(300);
    scene.background.color = {1, 128, 254};
    const Document document(scene);
    LivePicture picture;
    EXPECT_EQ(picture.step(), 0);
    for (const PictureSize size : {PictureSize{320, 240}, {99, 201}, {1, 1}, {1200, 7}, {3840, 2160}, {33, 34}}) {
        const View view{scene.camera, size};
        EXPECT_TRUE(same(shown(picture, document, view), exported(scene, view))) << size.width << "x" << size.height;
        EXPECT_EQ(picture.step(), 1);
        EXPECT_GT(picture.last_seconds(), 0.0);
    }
    EXPECT_EQ(picture.storage(), "uniform buffer");
}

TEST_P(LivePictureTest, ShowsAnyCamera) {
    const Scene scene = colorful_scene(300);
    const Document document(scene);
    LivePicture picture;
    View view{scene.camera, {200, 150}};
    shown(picture, document, view);
    view.camera.eye.x = 20.0;  // the screen stays: an oblique view
    EXPECT_TRUE(same(shown(picture, document, view), exported(scene, view)));
    view.camera.center.z = 60.0;  // the eye stays
    EXPECT_TRUE(same(shown(picture, document, view), exported(scene, view)));
}

// A coarse picture is the fine one at the pixels that were traced. Between them it is smooth: far fewer pixels differ than if each
// traced one stood for a square.
TEST_P(LivePictureTest, CoarsePictureIsSmoothBetweenThePixelsThatAreTraced) {
    const Scene scene = colorful_scene(30);
    const Document document(scene);
    for (const PictureSize size : {PictureSize{203, 101}, {1, 1}, {3, 50}}) {
        const View view{scene.camera, size};
        const Image fine = colored(scene, view, numbers(scene, view));
        LivePicture picture;
        for (const int step : steps) {
            const Image image = shown(picture, document, view, step);
            int squares = 0;
            int wrong = 0;
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x < size.width; ++x) {
                    const int traced_x = std::min(x / step * step + step / 2, size.width - 1);
                    const int traced_y = std::min(y / step * step + step / 2, size.height - 1);
                    if (x == traced_x && y == traced_y) {
                        ASSERT_EQ(at(image, x, y), at(fine, x, y)) << x << "," << y << " step " << step;
                    }
                    squares += at(fine, traced_x, traced_y) == at(fine, x, y) ? 0 : 1;
                    wrong += at(image, x, y) == at(fine, x, y) ? 0 : 1;
                }
            }
            EXPECT_LE(3 * wrong, squares + 9) << "step " << step << " of " << size.width;
            EXPECT_EQ(picture.step(), step);
            EXPECT_FALSE(picture.update(document, view, step));
        }
        EXPECT_FALSE(picture.update(document, view, 4));  // it has better
        EXPECT_EQ(picture.step(), 1);
    }
}

// The eye is in all of them and near to their backs, so that no ray's walk ends before it has tried all.
Scene overlapping(int count) {
    Scene scene;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 center{20.0 * (i % 7 - 3), 30.0 * (i % 3 - 1), 500};
        scene.spheres.push_back({center, 1000 + 0.02 * i, {static_cast<std::uint8_t>(20 * i), 9, 9}, false});
    }
    return scene;
}

// How many pixels differ.
int differences(const Image& a, const Image& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) count += at(a, x, y) == at(b, x, y) ? 0 : 1;
    }
    return count;
}

// Goes on with a coarse picture until every pixel is traced; returns how often it stayed as it was.
int refine(LivePicture& picture, const Document& document, const View& view) {
    int parts = 0;
    const Image coarse = drawn_into_window(picture, document, view, {});
    const int step = picture.step();
    EXPECT_GT(step, 1);
    while (picture.step() > 1 && !picture.update(document, view, 1, Shading::flat, {}, 0.0)) {
        ++parts;
        EXPECT_EQ(picture.step(), step);
        EXPECT_TRUE(same(drawn_into_window(picture, document, view, {}), coarse));
        EXPECT_FALSE(picture.update(document, view, 2)) << "a finer one is on its way";
    }
    return parts;
}

TEST_P(LivePictureTest, ThereIsACoarsePictureAtOnceAndAFineOnePartByPart) {
    // More than 20,000 spheres have lists for the coarse pixels alone.
    for (const int count : {600, 25'000}) {
        const Scene scene = overlapping(count);
        Document document(scene);
        const View view{scene.camera, count > 1000 ? PictureSize{20, 20} : PictureSize{100, 100}};
        const Image expected = exported(scene, view);
        for (const int step : {1, 8}) {
            LivePicture picture;
            EXPECT_TRUE(picture.update(document, view, step, Shading::flat, {}, 0.0));
            if (step == 1) {
                EXPECT_EQ(picture.step(), LivePicture::coarsest_step);
            }
            EXPECT_GT(refine(picture, document, view), 1);
            EXPECT_TRUE(same(drawn_into_window(picture, document, view, {}), expected));
            // An edit in the middle begins anew.
            Sphere sphere = document.scene().spheres[0];
            for (const double radius : {1.0, sphere.radius}) {
                sphere.radius = radius;
                document.apply(change(0, sphere), "radius");
                EXPECT_TRUE(picture.update(document, view, 8, Shading::flat, {}, 0.0));
                EXPECT_FALSE(picture.update(document, view, 1, Shading::flat, {}, 0.0));
            }
            EXPECT_GT(refine(picture, document, view), 0);
            // Guesses may be others in lists that have followed edits.
            EXPECT_LE(differences(drawn_into_window(picture, document, view, {}), expected), view.size.width / 20);
        }
        LivePicture at_once;
        EXPECT_TRUE(same(shown(at_once, document, view), expected));
    }
}

TEST_P(LivePictureTest, KeepsToItsAreaOfTheWindow) {
    const Scene scene = two_spheres();
    const Document document(scene);
    LivePicture picture;
    const View view{scene.camera, {60, 40}};
    const Image alone = shown(picture, document, view);
    Selection all;
    all.set({0, 1});
    for (const bool outlined : {false, true}) {
        const WindowTarget window(100, 90);
        picture.show({30, 20, 60, 40}, scene.background, {outlined ? &all : nullptr, {}, 5.0F});
        const Image pixels = window.pixels();
        for (int y = 0; y < 90; ++y) {
            for (int x = 0; x < 100; ++x) {
                const bool inside = x >= 30 && x < 90 && y >= 30 && y < 70;  // GL counts rows from the bottom
                if (!inside) {
                    EXPECT_EQ(at(pixels, x, y), (Rgba{17, 34, 51, 255})) << x << "," << y;
                } else if (!outlined) {
                    EXPECT_EQ(at(pixels, x, y), at(alone, x - 30, y - 30)) << x << "," << y;
                }
            }
        }
    }
    // More area than picture, as while a window is being resized: its edge goes on.
    const WindowTarget window(70, 50);
    picture.show({0, 0, 70, 50}, scene.background, {});
    EXPECT_EQ(at(window.pixels(), 30, 20), opaque(red));
    EXPECT_EQ(at(window.pixels(), 69, 49), opaque({0, 0, 0}));
    picture.show({0, 0, 0, 0}, scene.background, {});  // a minimised window
}

TEST_P(LivePictureTest, ShowsTheBackgroundBeforeThereIsAPicture) {
    LivePicture picture;
    const WindowTarget window(5, 4);
    picture.show({0, 0, 5, 4}, {{9, 8, 7}, false}, {});
    EXPECT_EQ(at(window.pixels(), 2, 2), opaque({9, 8, 7}));
    EXPECT_EQ(picture.pick(Document(two_spheres()), {2, 2}), visible_background);
}

TEST_P(LivePictureTest, ShowsACheckerboardWhereTheBackgroundIsTransparent) {
    Scene scene = two_spheres();
    scene.background.transparent = true;
    const Document document(scene);
    LivePicture picture;
    const Image pixels = shown(picture, document, {scene.camera, {100, 100}});
    EXPECT_EQ(at(pixels, 50, 50), opaque(red));
    EXPECT_EQ(at(pixels, 0, 0), opaque({153, 153, 153}));
    EXPECT_EQ(at(pixels, 8, 0), opaque({102, 102, 102}));
    EXPECT_EQ(at(pixels, 8, 8), opaque({153, 153, 153}));
}

TEST_P(LivePictureTest, WhateverElseIsSwitchedOnAndBound) {
    const Scene scene = two_spheres();
    const Document document(scene);
    const View view{scene.camera, {50, 50}};
    LivePicture picture;
    const Image expected = shown(picture, document, view);
    LivePicture again;
    const WindowTarget window(50, 50);
    const auto disturb = [] {
        for (const GLenum what : {GL_BLEND, GL_SCISSOR_TEST, GL_CULL_FACE, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_DITHER,
                                  GL_FRAMEBUFFER_SRGB, GL_COLOR_LOGIC_OP}) {
            glEnable(what);
        }
        glCullFace(GL_FRONT_AND_BACK);
        glBlendFunc(GL_ONE, GL_ONE);
        glScissor(3, 3, 5, 5);
        glViewport(1, 2, 3, 4);
        glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        for (GLenum unit = 0; unit < 6; ++unit) {
            glActiveTexture(GL_TEXTURE0 + unit);
            glBindTexture(GL_TEXTURE_2D, 0);
            glBindTexture(GL_TEXTURE_BUFFER, 0);
        }
        for (GLuint block = 0; block < 3; ++block) glBindBufferBase(GL_UNIFORM_BUFFER, block, 0);
        glBindVertexArray(0);
        glUseProgram(0);
    };
    disturb();
    EXPECT_TRUE(again.update(document, view, 1));
    EXPECT_EQ(gl_limit(GL_DRAW_FRAMEBUFFER_BINDING), gl_limit(GL_READ_FRAMEBUFFER_BINDING));
    disturb();
    again.show({0, 0, 50, 50}, scene.background, {});
    EXPECT_TRUE(same(window.pixels(), expected));
    disturb();
    EXPECT_EQ(again.pick(document, {25, 25}), 0);
    again.show({0, 0, 50, 50}, scene.background, {});
    EXPECT_FALSE(glIsEnabled(GL_BLEND) || glIsEnabled(GL_SCISSOR_TEST) || glIsEnabled(GL_DEPTH_TEST));
    EXPECT_TRUE(same(window.pixels(), expected));
}

TEST_P(LivePictureTest, FollowsEveryEditAndTracesOnlyForThoseOfForm) {
    Document document(two_spheres());
    const View view{document.scene().camera, {100, 100}};
    LivePicture picture;
    EXPECT_EQ(at(shown(picture, document, view), 50, 50), opaque(red));
    EXPECT_FALSE(picture.update(document, view, 1));

    Sphere sphere = document.scene().spheres[0];
    sphere.color = {1, 2, 3};
    document.apply(change(0, sphere), "colour");
    EXPECT_EQ(at(shown_again(picture, document, view), 50, 50), opaque({1, 2, 3}));
    document.undo();
    EXPECT_EQ(at(shown_again(picture, document, view), 50, 50), opaque(red));

    document.apply(RenameSphere{0, "sun"}, "rename");
    EXPECT_FALSE(picture.update(document, view, 1));
    document.apply(ChangeBackground{{{0, 99, 0}, false}}, "background");
    EXPECT_EQ(at(shown_again(picture, document, view), 0, 0), opaque({0, 99, 0}));
    Camera other = view.camera;
    other.eye.x = 5.0;
    document.apply(ChangeCamera{other}, "camera");  // the scene's own; the view is the window's
    EXPECT_FALSE(picture.update(document, view, 1));

    sphere.center.x = -80.0;
    document.apply(change(0, sphere), "move");
    Image pixels = shown(picture, document, view);
    EXPECT_EQ(at(pixels, 50, 50), opaque({0, 99, 0}));
    EXPECT_EQ(at(pixels, 10, 50), opaque({1, 2, 3}));
    sphere.hidden = true;
    document.apply(change(0, sphere), "hide");
    EXPECT_EQ(at(shown(picture, document, view), 10, 50), opaque({0, 99, 0}));
    // Of spheres that are left out, the colours of the others are still theirs.
    Sphere second = document.scene().spheres[1];
    second.color = {9, 9, 9};
    document.apply(change(1, second), "colour");
    sphere.color = red;
    document.apply(change(0, sphere), "colour of what nobody sees");
    EXPECT_EQ(at(shown_again(picture, document, view), 70, 50), opaque({9, 9, 9}));

    document.apply(RemoveSpheres{{0, 1}}, "delete");
    EXPECT_EQ(at(shown(picture, document, view), 70, 50), opaque({0, 99, 0}));
    EXPECT_EQ(picture.pick(document, {70, 50}), visible_background);
    document.apply(InsertSpheres{{0}, {{two_spheres().spheres[1], ""}}}, "add");
    EXPECT_EQ(at(shown(picture, document, view), 70, 50), opaque(blue));
    // Another document is another scene, whatever it holds.
    EXPECT_TRUE(picture.update(Document(document.scene()), view, 1));
}

TEST_P(LivePictureTest, ShowsManySpheresFromEveryKindOfTexture) {
    const Scene scene = colorful_scene(5'000 * 3 / 2);
    Document document(scene);
    const View view{scene.camera, {300, 200}};
    const Image expected = exported(scene, view);
    LivePicture from_buffers;
    LivePicture in_two_dimensions("", {.in_buffer = 1000});
    Selection selection;
    selection.set({0, 1, 2, 3, 4});
    for (LivePicture* picture : {&from_buffers, &in_two_dimensions}) {
        EXPECT_TRUE(same(shown(*picture, document, view), expected));
        const Image outlined = shown_again(*picture, document, view, {&selection, {}, 2.0F});
        EXPECT_FALSE(same(outlined, expected));
        EXPECT_TRUE(same(shown_again(*picture, document, view), expected));
    }
    EXPECT_EQ(from_buffers.storage(), "buffer textures");
    EXPECT_EQ(in_two_dimensions.storage(), "2D textures");

    // Too many leave the picture as it was.
    LivePicture small("", {.in_buffer = 100, .side = 64});
    Document few(two_spheres());
    const View little{scene.camera, {9, 9}};
    const Image before = shown(small, few, little);
    EXPECT_THROW(small.update(document, little, 1), TooLarge);
    const WindowTarget window(9, 9);
    small.show({0, 0, 9, 9}, few.scene().background, {});
    EXPECT_TRUE(same(window.pixels(), before));
    EXPECT_FALSE(small.update(few, little, 1));
    EXPECT_THROW(small.update(few, {scene.camera, {1'000'000, 1}}, 8), TooLarge);
}

TEST_P(LivePictureTest, PicksWhatAnExportShows) {
    Scene scene = colorful_scene(300);
    // Two in one place that differ in the last bit: doubtful wherever one of them is seen.
    scene.spheres.push_back({{0, 0, 120}, 9, red, false});
    scene.spheres.push_back({{0, 0, 120}, 9 + 0x1p-49, blue, false});
    const Document document(scene);
    const View view{scene.camera, {61, 47}};
    const DrawnSpheres drawn = drawn_spheres(scene);
    const Resolver resolver(scene, drawn, view.size);
    LivePicture picture;
    for (const int step : {4, 1}) {
        picture.update(document, view, step);
        int doubtful_ones = 0;
        for (int y = 0; y < view.size.height; ++y) {
            for (int x = 0; x < view.size.width; ++x) {
                DecisionLevel level{};
                const std::int32_t expected = resolver.resolve({x, y}, level);
                EXPECT_EQ(picture.pick(document, {x, y}), expected) << x << "," << y;
                doubtful_ones += expected == 301 ? 1 : 0;
            }
        }
        EXPECT_GT(doubtful_ones, 5);
    }
    for (const Pixel outside : {Pixel{-1, 0}, {0, -1}, {61, 0}, {0, 47}}) {
        EXPECT_EQ(picture.pick(document, outside), visible_background);
    }
}

TEST_P(LivePictureTest, PicksFromTheDocumentAsItIsNow) {
    Document document(two_spheres());
    const View view{document.scene().camera, {100, 100}};
    LivePicture picture;
    picture.update(document, view, 1);
    EXPECT_EQ(picture.pick(document, {50, 50}), 0);
    EXPECT_EQ(picture.pick(document, {70, 50}), 1);
    document.apply(RemoveSpheres{{0}}, "delete");  // not yet in the picture
    EXPECT_EQ(picture.pick(document, {50, 50}), visible_background);
    EXPECT_EQ(picture.pick(document, {70, 50}), 0);
}

INSTANTIATE_TEST_SUITE_P(Contexts, LivePictureTest, testing::ValuesIn(context_kinds()), testing::PrintToStringParamName());

}  // namespace
}  // namespace sphereview::test

// The window's picture with several points a pixel: what an export has, however little by little it is made.
#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <thread>

#include "cpu/cpu_renderer.hpp"
#include "exact/resolve.hpp"
#include "gl/contexts.hpp"
#include "gl/live.hpp"
#include "image/average.hpp"
#include "scene/samples.hpp"
#include "shade/picture_shader.hpp"
#include "shade/shade.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

Scene random_spheres(int count) {
    std::mt19937 random(11);
    const auto number = [&](int low, int high) { return low + static_cast<int>(random() % static_cast<unsigned>(high - low)); };
    Scene scene;
    for (int i = 0; i < count; ++i) {
        const auto channel = [&] { return static_cast<std::uint8_t>(number(0, 256)); };
        scene.spheres.push_back({{number(-100, 100), number(-100, 100), number(90, 300)},
                                 0.25 * number(1, 60),
                                 {channel(), channel(), channel()},
                                 i % 7 == 3});
    }
    return scene;
}

// An export with samples, on this background; RGB, or RGBA if that is transparent.
Image exported(const Scene& scene, const View& view, int samples, const Background& background, Shading shading = Shading::flat) {
    const int side = sample_side(samples);
    const PictureSize size = sampled_size(view.size, side);
    const DrawnSpheres drawn = drawn_spheres(scene, view.camera);
    const CandidateLists lists = build_lists(drawn, view.camera, size, cpu_tile_costs);
    const Block whole{0, 0, size.width, size.height};
    std::vector<std::int32_t> visible(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    CpuRenderer(drawn, lists, view.camera, size).trace(whole, visible);
    Resolver(scene, drawn, view.camera, size, &lists).certify(whole, visible);
    Image points = make_picture(size, background);
    Scene seen = scene;
    seen.camera = view.camera;
    PictureShader(seen, size, shading, background).shade(whole, visible, points);
    Image picture = make_picture(view.size, background);
    average_into(points, side, picture, 0, 0);
    return picture;
}

// As the window has it.
Image opaque(const Image& rgb) {
    Image rgba(rgb.width(), rgb.height(), 4);
    for (int y = 0; y < rgb.height(); ++y) {
        for (int x = 0; x < rgb.width(); ++x) {
            std::copy_n(rgb.at(x, y), 3, rgba.at(x, y));
            rgba.at(x, y)[3] = 255;
        }
    }
    return rgba;
}

// How often refine() had to be called. A time of 0: as little as possible each time.
int refine(LivePicture& picture, const Document& document, int samples, double seconds = 1.0) {
    int calls = 0;
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (!picture.is_refined(samples, document.scene().background) && std::chrono::steady_clock::now() < end) {
        picture.refine(document, samples, document.scene().background, seconds);
        if (picture.refining_waits()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ++calls;
    }
    EXPECT_TRUE(picture.is_refined(samples, document.scene().background));
    return calls;
}

Image window(LivePicture& picture, const Document& document, const View& view, int samples, const Highlights& highlights = {}) {
    const WindowTarget target(view.size.width, view.size.height);
    picture.show({0, 0, view.size.width, view.size.height}, document.scene().background, highlights, samples);
    return target.pixels();
}

// Brings the picture up to date, refines it and expects the export's average.
void expect_average(LivePicture& picture, const Document& document, const View& view, int samples, double seconds = 1.0) {
    picture.update(document, view, 1);
    refine(picture, document, samples, seconds);
    ASSERT_TRUE(picture.is_averaged(samples, document.scene().background));
    const Image expected = opaque(exported(document.scene(), view, samples, document.scene().background));
    EXPECT_TRUE(same(window(picture, document, view, samples), expected)) << samples;
}

class SampledPictureTest : public testing::TestWithParam<ContextKind> {
protected:
    std::unique_ptr<GlContext> context_ = GetParam().open();
};

TEST_P(SampledPictureTest, IsTheExportsAverageAtEverySize) {
    Scene scene = random_spheres(200);
    scene.background.color = {1, 128, 254};
    const Document document(scene);
    LivePicture picture;
    for (const PictureSize size : {PictureSize{320, 240}, {99, 201}, {1, 1}, {2500, 7}, {33, 34}}) {
        for (const int samples : {4, 16}) expect_average(picture, document, {scene.camera, size}, samples);
    }
}

TEST_P(SampledPictureTest, IsShadedAsTheExportIs) {
    const Document document(random_spheres(200));
    const View view{document.scene().camera, {200, 150}};
    LivePicture picture;
    for (const int samples : {4, 16}) {
        for (const Shading shading : {Shading::headlight, Shading::id, Shading::normal, Shading::depth, Shading::flat}) {
            picture.update(document, view, 1, shading);
            refine(picture, document, samples);
            const Image expected = opaque(exported(document.scene(), view, samples, {}, shading));
            const Image found = window(picture, document, view, samples);
            int worst = 0;
            for (int y = 0; y < view.size.height; ++y) {
                for (int i = 0; i < 4 * view.size.width; ++i)
                    worst = std::max(worst, std::abs(found.at(0, y)[i] - expected.at(0, y)[i]));
            }
            EXPECT_LE(worst, depends_on_hit(shading) ? 1 : 0) << samples << ", " << name_of(shading);
            EXPECT_FALSE(same(found, window(picture, document, view, 1))) << "anti-aliased";
        }
    }
}

TEST_P(SampledPictureTest, IsDecidedExactlyLittleByLittle) {
    Scene scene = random_spheres(50);
    // Two in one place that differ in the last bit: doubtful wherever one of them is seen. And the eye on a surface.
    scene.spheres.push_back({{0, 0, 120}, 30, red, false});
    scene.spheres.push_back({{0, 0, 120}, 30 + 0x1p-48, blue, false});
    scene.spheres.push_back({{0, 0, -10}, 10, blue, false});
    const Document document(scene);
    LivePicture picture;
    const View view{scene.camera, {150, 140}};
    picture.update(document, view, 1);
    const Image plain = window(picture, document, view, 1);
    EXPECT_FALSE(picture.is_refined(4, scene.background));
    picture.refine(document, 4, scene.background, 0.0);
    EXPECT_FALSE(picture.is_refined(4, scene.background));
    EXPECT_TRUE(same(window(picture, document, view, 4), plain)) << "until all of it is there";
    EXPECT_GT(refine(picture, document, 4, 0.0), 4);
    expect_average(picture, document, view, 4);
    EXPECT_TRUE(same(window(picture, document, view, 1), plain)) << "is still there";
}

TEST_P(SampledPictureTest, BeginsAnewAfterEveryChange) {
    Document document(random_spheres(100));
    LivePicture picture;
    View view{document.scene().camera, {120, 90}};
    expect_average(picture, document, view, 4);
    const auto changed = [&](const char* what) {
        SCOPED_TRACE(what);
        picture.update(document, view, 1);
        EXPECT_FALSE(picture.is_averaged(4, document.scene().background));
        picture.refine(document, 4, document.scene().background, 0.0);  // a beginning, which the next change interrupts
        expect_average(picture, document, view, 4);
    };
    Sphere sphere = document.scene().spheres[0];
    sphere.color = {7, 8, 9};
    document.apply(change(0, sphere), "colour");
    changed("colour");
    sphere.center = {0, 0, 90};
    sphere.radius = 25;
    document.apply(change(0, sphere), "move");
    changed("form");
    document.apply(ChangeBackground{{{0, 99, 0}, false}}, "background");
    changed("background");
    view.camera.eye.x = 10.0;
    changed("view");
    view.size = {90, 120};
    changed("size");
    document.undo();
    document.undo();
    changed("undo");
    expect_average(picture, document, view, 16);
    expect_average(picture, document, view, 4);
}

TEST_P(SampledPictureTest, StaysWhileOnlyMarksChange) {
    Scene scene = random_spheres(100);
    scene.background.color = {200, 200, 200};  // on which dark lines are seen, too
    const Document document(scene);
    LivePicture picture;
    const View view{scene.camera, {120, 90}};
    picture.update(document, view, 1);
    Selection selection;
    selection.set({1, 2, 4, 5, 6, 8});
    const Highlights marks{&selection, {}, 2.0F};
    const Image plain = window(picture, document, view, 1);
    const Image plain_marked = window(picture, document, view, 1, marks);
    refine(picture, document, 4);
    const Image average = window(picture, document, view, 4);
    const Image marked = window(picture, document, view, 4, marks);
    int outlined = 0;
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 120; ++x) {
            if (at(plain_marked, x, y) == at(plain, x, y)) {
                EXPECT_EQ(at(marked, x, y), at(average, x, y)) << x << "," << y;
            } else if (at(plain_marked, x, y) == Rgba{255, 166, 0, 255}) {
                EXPECT_EQ(at(marked, x, y), at(plain_marked, x, y)) << x << "," << y;
                ++outlined;
            }
        }
    }
    EXPECT_GT(outlined, 20);
    EXPECT_FALSE(picture.update(document, view, 1));
    EXPECT_TRUE(picture.is_averaged(4, scene.background));
}

TEST_P(SampledPictureTest, ShowsACheckerboardThroughWhatIsPartlyCovered) {
    Scene scene = two_spheres();
    scene.background.transparent = true;
    const Document document(scene);
    LivePicture picture;
    const View view{scene.camera, {100, 90}};
    picture.update(document, view, 1);
    refine(picture, document, 16);
    const Image pixels = window(picture, document, view, 16);
    const Image light = exported(scene, view, 16, {{153, 153, 153}, false});
    const Image dark = exported(scene, view, 16, {{102, 102, 102}, false});
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 100; ++x) {
            const std::uint8_t* expected = ((x / 8 + y / 8) % 2 == 0 ? light : dark).at(x, y);
            EXPECT_EQ(at(pixels, x, y), (Rgba{expected[0], expected[1], expected[2], 255})) << x << "," << y;
        }
    }
}

TEST_P(SampledPictureTest, HoldsSpheresInEveryKindOfTexture) {
    const Scene scene = random_spheres(6000);
    const Document document(scene);
    LivePicture from_buffers;
    LivePicture in_two_dimensions("", {.in_buffer = 1000});
    for (LivePicture* picture : {&from_buffers, &in_two_dimensions}) {
        expect_average(*picture, document, {scene.camera, {150, 100}}, 4);
    }
}

TEST_P(SampledPictureTest, IsMadeByTheFoldersShaders) {
    const TemporaryFolder folder;
    const std::string begin = "#version 330 core\nout vec4 color;\nvoid main() { color = ";
    const std::string half_red = begin + "vec4(0.5, 0.0, 0.0, 1.0); }\n";
    folder.write("shade.frag", half_red);
    const Document document(two_spheres());
    const View view{{}, {40, 40}};
    LivePicture picture(folder.path());
    picture.update(document, view, 1);
    refine(picture, document, 16);
    EXPECT_EQ(at(window(picture, document, view, 16), 3, 3), (Rgba{128, 0, 0, 255}));
    folder.write("shade.frag", begin + "vec4(0.0, 1.0, 0.0, 1.0); }\n");
    EXPECT_EQ(picture.reload_shaders(), "");
    EXPECT_TRUE(picture.update(document, view, 1));
    EXPECT_FALSE(picture.is_averaged(16, {}));
    refine(picture, document, 16);
    EXPECT_EQ(at(window(picture, document, view, 16), 3, 3), (Rgba{0, 255, 0, 255}));
    folder.write("average.frag", begin + "broken; }\n");
    EXPECT_TRUE(contains(picture.reload_shaders(), "average.frag:3")) << picture.shader_log();
    EXPECT_TRUE(picture.is_averaged(16, {}));
}

// The lists of so many are made by another thread.
TEST_P(SampledPictureTest, OfManySpheresFollowsChangesToo) {
    Document document(random_spheres(30'000));
    LivePicture picture;
    const View view{document.scene().camera, {100, 80}};
    for (int i = 0; i < 3; ++i) {
        picture.update(document, view, 1);
        picture.refine(document, i == 1 ? 16 : 4, document.scene().background, 0.0);
        EXPECT_TRUE(picture.refining_waits());
        Sphere sphere = document.scene().spheres[0];
        sphere.center = {10.0 * i, 0, 85};
        sphere.radius = 10;
        document.apply(change(0, sphere), "move");  // while they are made
    }
    expect_average(picture, document, view, 4);
}

TEST_P(SampledPictureTest, ThatTheContextCannotHoldIsLeftOut) {
    const Scene scene = random_spheres(300);
    const Document document(scene);
    const View view{scene.camera, {300, 300}};
    const DrawnSpheres drawn = drawn_spheres(scene);
    const auto longest = [&](int side) {
        const CandidateLists lists = build_lists(drawn, view.camera, sampled_size(view.size, side), gpu_tile_costs);
        return std::max(lists.begins.size(), lists.candidates.size()) + 1;
    };
    ASSERT_LT(longest(1), longest(4));
    LivePicture picture("", {.in_buffer = longest(4) - 1, .side = 1});
    const Image plain = shown(picture, document, view);
    refine(picture, document, 16);
    EXPECT_FALSE(picture.is_averaged(16, scene.background));
    EXPECT_TRUE(same(window(picture, document, view, 16), plain));
}

INSTANTIATE_TEST_SUITE_P(Contexts, SampledPictureTest, testing::ValuesIn(context_kinds()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace sphereview::test

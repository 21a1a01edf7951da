// The window's shading against the export's: within 1 of 255; and exports of all backends: the same bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "exact/resolve.hpp"
#include "gl/contexts.hpp"
#include "gl/live.hpp"
#include "light/lighting.hpp"
#include "shade/picture_shader.hpp"
#include "support/render.hpp"
#include "support/shaded_scenes.hpp"
#include "support/spheres.hpp"

namespace sphereview::test {
namespace {

std::vector<Scene> scenes() {
    std::vector<Scene> all = shaded_scenes();
    all[0].spheres[3].hidden = true;
    all[0].spheres.push_back({{0, 0, 30}, 30, {200, 100, 50}, false});  // the eye on its surface
    all.push_back(shaded_scene(40, 5));
    all.back().camera.center = {60.0, -20.0, 100.0};  // off the axis
    all.push_back(shaded_scene(40, 6));
    for (Sphere& sphere : all.back().spheres) {  // a scale of its own
        sphere.center = sphere.center * 1e-30;
        sphere.radius *= 1e-30;
    }
    for (const double z : {0.0, 200.0}) {  // parallel rays from before all spheres, and from a plane that meets some
        all.push_back(shaded_scene(40, 7));
        all.back().camera = {{0, 0, z}, {15, -10, z + 100}, {120, 0, 0}, {0, 120, 0}, Projection::orthographic};
    }
    return all;
}

using WindowShading = InContext;

TEST_P(WindowShading, IsWithinOneOfTheExports) {
    int which = 0;
    for (const Scene& scene : scenes()) {
        const Document document(scene);
        const View view{scene.camera, {203, 151}};
        const DrawnSpheres drawn = drawn_spheres(scene);
        const Resolver resolver(scene, drawn, view.size);
        std::vector<std::pair<Pixel, std::int32_t>> seen_in_float;  // of doubtful pixels the window shows guesses
        for (int y = 0; y < view.size.height; ++y) {
            for (int x = 0; x < view.size.width; ++x) {
                if (decision_level(scene, drawn, view.camera, view.size, {x, y}) != DecisionLevel::in_float) continue;
                DecisionLevel level{};
                seen_in_float.emplace_back(Pixel{x, y}, resolver.resolve({x, y}, level));
            }
        }
        EXPECT_GT(std::ranges::count_if(seen_in_float, [](const auto& seen) { return seen.second >= 0; }), 5000) << which;
        LivePicture picture;
        EXPECT_TRUE(picture.update(document, view, 1));
        for (const ShadingMode& words : shading_modes) {
            if (words.is_lit) continue;  // what moves has no shadows
            const Shading mode = shading_named(words.name).value();
            EXPECT_FALSE(picture.update(document, view, 1, mode));
            const Image window = drawn_into_window(picture, document, view, {});
            const PictureShader shader(scene, scene.camera, view.size, mode, scene.background);
            int worst = 0;
            for (const auto& [pixel, number] : seen_in_float) {
                const Color expected = shader.color(pixel, number);
                const Rgba seen = at(window, pixel.x, pixel.y);
                worst = std::max(
                    {worst, std::abs(seen[0] - expected.r), std::abs(seen[1] - expected.g), std::abs(seen[2] - expected.b)});
            }
            EXPECT_LE(worst, words.depends_on_hit ? 1 : 0) << "scene " << which << ", " << words.name;
        }
        ++which;
    }
}

// A free sphere has no shadow but its own, so what moves looks nearly like the export.
TEST_P(WindowShading, OfLightIsNearlyTheExports) {
    Scene scene = scene_of({{{10, -5, 200}, 60, {220, 160, 90}, false}});
    for (const Light& light : {Light{}, Light{.lights = {}, .sky = 0.4, .sun = Sun{{3.0, 1.0, -2.0}, 0.8}}}) {
        scene.light = light;
        scene.light.lights = 1024;
        const Document document(scene);
        const View view{scene.camera, {101, 101}};
        LivePicture picture;
        picture.update(document, view, 1, Shading::studio);
        const Image window = drawn_into_window(picture, document, view, {});
        const DrawnSpheres drawn = drawn_spheres(scene);
        const Resolver resolver(scene, drawn, view.size);
        const Lighting lighting(scene, drawn, scene.camera, view.size, 1, scene.light);
        const PictureShader shader(scene, scene.camera, view.size, Shading::studio, scene.background);
        std::vector<std::int32_t> visible;
        for (int y = 0; y < 101; ++y) {
            for (int x = 0; x < 101; ++x) {
                DecisionLevel level{};
                visible.push_back(resolver.resolve({x, y}, level));
            }
        }
        const std::vector<LightVector> lit = lighting.light({0, 0, 101, 101}, visible);
        int worst = 0;
        for (std::size_t i = 0; i < visible.size(); ++i) {
            const Pixel pixel{static_cast<int>(i) % 101, static_cast<int>(i) / 101};
            // Of doubtful pixels the window shows guesses.
            if (decision_level(scene, drawn, view.camera, view.size, pixel) != DecisionLevel::in_float) continue;
            const Color expected = shader.color(pixel, visible[i], lit[i]);
            const Rgba seen = at(window, pixel.x, pixel.y);
            worst =
                std::max({worst, std::abs(seen[0] - expected.r), std::abs(seen[1] - expected.g), std::abs(seen[2] - expected.b)});
        }
        EXPECT_LE(worst, 6);
    }
}

// Each pixel is shaded where its own ray meets the sphere.
TEST_P(WindowShading, OfACoarsePictureIsSmooth) {
    const Scene scene = shaded_scene(40, 9);
    const Document document(scene);
    const View view{scene.camera, {101, 67}};
    LivePicture fine;
    fine.update(document, view, 1, Shading::normal);
    const Image expected = drawn_into_window(fine, document, view, {});
    LivePicture coarse;
    coarse.update(document, view, 4, Shading::normal);
    const Image seen = drawn_into_window(coarse, document, view, {});
    const auto differ = [](const Rgba& a, const Rgba& b) {
        return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])}) > 1;
    };
    int wrong = 0;
    int squares = 0;
    for (int y = 0; y < 67; ++y) {
        for (int x = 0; x < 101; ++x) {
            const Pixel traced{std::min(x / 4 * 4 + 2, 100), std::min(y / 4 * 4 + 2, 66)};
            if (x == traced.x && y == traced.y) {
                EXPECT_EQ(at(seen, x, y), at(expected, x, y)) << x << "," << y;
            }
            wrong += differ(at(seen, x, y), at(expected, x, y)) ? 1 : 0;
            squares += differ(at(expected, traced.x, traced.y), at(expected, x, y)) ? 1 : 0;
        }
    }
    EXPECT_LT(5 * wrong, squares);
}

TEST_P(WindowShading, FollowsEdits) {
    Document document(two_spheres());
    const View view{document.scene().camera, {100, 100}};
    LivePicture picture;
    picture.update(document, view, 1, Shading::id);
    const Rgba before = at(drawn_into_window(picture, document, view, {}), 50, 50);
    Sphere sphere = document.scene().spheres[0];
    sphere.color = {1, 2, 3};
    document.apply(change(0, sphere), "colour");
    EXPECT_FALSE(picture.update(document, view, 1, Shading::id));
    EXPECT_EQ(at(drawn_into_window(picture, document, view, {}), 50, 50), before);  // false colours know numbers alone
    EXPECT_FALSE(picture.update(document, view, 1, Shading::flat));
    EXPECT_EQ(at(drawn_into_window(picture, document, view, {}), 50, 50), opaque({1, 2, 3}));
}

INSTANTIATE_TEST_SUITE_P(Contexts, WindowShading, testing::ValuesIn(context_kinds()), testing::PrintToStringParamName());

TEST(ShadedExport, IsTheSameOnEveryBackend) {
    const std::string scene = "4\n200 30 40 0 0 300 90\n1 255 3 40 25.5 180 20\n0 0 255 -30 10 150 35\n90 90 90 0 5 10 700\n";
    for (const ShadingMode& mode : shading_modes) {
        const std::vector<std::string> options = {"-s", "400x300", "--shade", std::string(mode.name)};
        const Picture expected = picture_of(scene, "cpu", options);
        for (const char* backend : {"egl", "osmesa"}) EXPECT_EQ(picture_of(scene, backend, options), expected) << backend;
    }
}

}  // namespace
}  // namespace sphereview::test

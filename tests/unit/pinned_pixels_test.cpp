// The inspector's pixels, and pictures that are compared: what the window does with them, without a window.
#include "viewer/pinned_pixels.hpp"

#include <gtest/gtest.h>

#include "image/png.hpp"
#include "light/explain_light.hpp"
#include "light/lighting.hpp"
#include "support/eventually.hpp"
#include "support/spheres.hpp"
#include "support/temporary_folder.hpp"
#include "viewer/perform.hpp"
#include "viewer/scene_file.hpp"

namespace sphereview {

namespace {

struct Inspecting : testing::Test {
    Inspecting() : state(ViewOptions{}, ViewerSettings{}) {
        state.clipboard.set_text = [this](const std::string& text) { copied = text; };
        adopt(state, load_scene(folder.write("scene.txt", "2  255 0 0  0 30 300 50  0 0 255  -30 0 250 30")),
              folder.path("scene.txt"));
        state.picture_size = {60, 40};
        state.settings.shading = Shading::flat;
    }

    void compare(const std::string& name) {
        compare_with(state, folder.path(name));
        EXPECT_TRUE(test::eventually([&] {
            finish_work(state);
            return !is_working(state);
        }));
    }
    // What the window's loop does until the copy is there.
    void copy(InspectorWish wish) {
        perform(state, {wish});
        finish_copying();
    }
    void finish_copying() {
        EXPECT_TRUE(test::eventually([&] {
            finish_work(state);
            return !is_working(state);
        }));
    }
    // The scene as flat colours, upside down if it is to be wrong.
    void write_picture(const std::string& name, bool upside_down) {
        Image image(60, 40, 3);
        const DrawnSpheres drawn = drawn_spheres(state.scene());
        for (int y = 0; y < 40; ++y) {
            for (int x = 0; x < 60; ++x) {
                const Pixel pixel{x, upside_down ? 39 - y : y};
                const std::int32_t seen = explain_pixel(state.scene(), drawn, state.scene().camera, {60, 40}, pixel).visible();
                const Color color = seen < 0 ? Color{} : state.scene().spheres[static_cast<std::size_t>(seen)].color;
                image.at(x, y)[0] = color.r;
                image.at(x, y)[1] = color.g;
                image.at(x, y)[2] = color.b;
            }
        }
        folder.write(name, encode_png(image));
    }

    test::TemporaryFolder folder;
    ViewerState state;
    std::string copied;
};

const PinnedPixel one{{3, 4}, {60, 40}};
const PinnedPixel other{{5, 6}, {60, 40}};

}  // namespace

TEST(ExplainedLights, AddUpToTheLightOfTheExport) {
    Scene scene = scene_of({{{0, 0, 200}, 20, {200, 30, 40}}, {{0, 40, 180}, 15, {9, 9, 9}}, {{-15, 0, 165}, 8, {9, 9, 9}}});
    const PictureSize size{200, 200};
    const DrawnSpheres drawn = drawn_spheres(scene);
    for (const bool sun : {false, true}) {
        Light light;
        if (sun) light.sun = Sun{.direction = {1, 2, -1}};
        const Lighting lighting(scene, drawn, scene.camera, size, 1, light);
        const NumberedLights lights(light, scene.spheres.size(), scene.camera);
        int seen = 0;
        for (int i = 0; i < 20; ++i) {
            const Pixel pixel{80 + 2 * i, 90 + i};
            const std::int32_t visible = explain_pixel(scene, drawn, scene.camera, size, pixel).visible();
            if (visible < 0) continue;
            ++seen;
            const PixelLights found = explain_lights({scene, drawn, scene.camera, size, pixel, visible}, lights);
            ASSERT_TRUE(found.sum);
            EXPECT_EQ(*found.sum, lighting.light({pixel.x, pixel.y, 1, 1}, {&visible, 1}).front());
        }
        EXPECT_GT(seen, 10);
        EXPECT_EQ(explain_lights({scene, drawn, scene.camera, size, {100, 100}, 0}, lights, 1).sum.has_value(), false)
            << "not known where it would take too long";
    }
}

TEST(Pins, AreAFirstAndASecondAndGoInTurn) {
    PinnedPixels pins;
    EXPECT_FALSE(let_go(pins));
    pin(pins, one, true);  // beside nothing
    EXPECT_EQ(pins.first, one);
    pin(pins, other, false);
    EXPECT_EQ(pins.first, other);
    EXPECT_FALSE(pins.second);
    pins.second_is_next = true;
    pin(pins, one, false);
    EXPECT_EQ(pins.second, one);
    EXPECT_FALSE(pins.second_is_next);
    pins.second_is_next = true;
    EXPECT_TRUE(let_go(pins));
    EXPECT_TRUE(pins.second && !pins.second_is_next);
    EXPECT_TRUE(let_go(pins));
    EXPECT_TRUE(pins.first && !pins.second);
    EXPECT_TRUE(let_go(pins));
    EXPECT_FALSE(pins.first);
}

TEST(Pins, KeepTheirRayInEverySizeOfPicture) {
    EXPECT_EQ(place_in({60, 40}, one), glm::dvec2(3.5, 4.5));
    EXPECT_EQ(place_in({120, 80}, one), glm::dvec2(7.0, 9.0));
    EXPECT_EQ(place_in({40, 40}, {{30, 20}, {60, 40}}), glm::dvec2(20.5, 20.5));
}

TEST_F(Inspecting, CopiesTheWordsOfExplainForTheView) {
    state.camera.eye.x = 1.0;
    state.camera.center.x = 1.0;
    state.pins.last = one;
    copy(InspectorWish::copy);
    Scene scene = state.scene();
    scene.camera = state.camera;
    EXPECT_EQ(copied,
              explain(scene, "scene.txt",
                      {.scene = "", .pixel = {3, 4}, .size = {60, 40}, .data = {}, .fit = {}, .background = {}, .light = {}}));
    EXPECT_NE(copied.find("O = (1, 0, 0)"), std::string::npos) << copied;
    EXPECT_NE(state.messages.announcement.find("3, 4"), std::string::npos);
    perform(state, {InspectorWish::pin});
    EXPECT_EQ(state.pins.first, one);
    perform(state, {InspectorWish::compare});
    EXPECT_TRUE(state.pins.second_is_next);
    pin(state.pins, other, false);
    copy(InspectorWish::copy_second);
    EXPECT_NE(copied.find("pixel 5,6"), std::string::npos) << copied;
    perform(state, {InspectorWish::unpin});
    EXPECT_FALSE(state.pins.first || state.pins.second);
}

TEST_F(Inspecting, CopiesTheLightOfTheWindowAlsoWhereNoSunHasTheStrengthAskedFor) {
    state.settings.shading = Shading::studio;
    state.light.sun_strength = 2.0;
    state.pins.last = PinnedPixel{{30, 20}, {60, 40}};
    copy(InspectorWish::copy);
    EXPECT_NE(copied.find("pixel 30,20"), std::string::npos) << copied;
    EXPECT_TRUE(state.dialogs.empty());
}

TEST_F(Inspecting, CopiesBesideTheLoopTheLatestThatIsAskedFor) {
    state.pins.last = one;
    perform(state, {InspectorWish::copy});
    EXPECT_TRUE(copied.empty()) << "the loop does not wait for it";
    EXPECT_TRUE(is_working(state));
    state.pins.last = other;
    perform(state, {InspectorWish::copy});
    finish_copying();
    EXPECT_NE(copied.find("pixel 5,6"), std::string::npos) << copied;
    EXPECT_NE(state.messages.announcement.find("5, 6"), std::string::npos);
}

TEST_F(Inspecting, AnotherSceneHasNoComparison) {
    write_picture("mine.png", true);
    compare("mine.png");
    ASSERT_TRUE(state.comparison);
    compare_with(state, folder.path("mine.png"));
    adopt(state, load_scene(folder.path("scene.txt")), folder.path("scene.txt"));
    EXPECT_FALSE(state.comparison || state.comparing);
}

TEST_F(Inspecting, SpacePinsAndLetsGoWhereAPixelIsInspected) {
    const auto enabled = [&] { return info_of(commands_of(state), CommandId::pin_pixel).enabled; };
    EXPECT_FALSE(enabled());
    state.inspector_shown = true;
    EXPECT_FALSE(enabled());
    state.pins.last = one;
    EXPECT_TRUE(enabled());
    run_command(state, CommandId::pin_pixel);
    EXPECT_EQ(state.pins.first, one);
    run_command(state, CommandId::pin_pixel);
    EXPECT_FALSE(state.pins.first);
    perform(state, {PinPixel{{7, 8}, {100, 100}}});
    EXPECT_EQ(state.pins.first, (PinnedPixel{{7, 8}, {100, 100}}));
}

TEST_F(Inspecting, ComparesAPictureAndNamesTheMistake) {
    write_picture("right.png", false);
    compare("right.png");
    ASSERT_TRUE(state.comparison);
    EXPECT_TRUE(state.comparison->words.verdict.empty());
    EXPECT_FALSE(state.comparison->difference);
    EXPECT_EQ(state.comparison->words.counts, "Equal to the right picture: all 2,400 pixels.");

    write_picture("mine.png", true);
    // As the dialog has it.
    run_command(state, CommandId::compare_picture);
    const auto accept = std::get<FileBrowser>(state.dialogs.back()).accept;
    state.dialogs.clear();
    accept(folder.path("mine.png"), {});
    EXPECT_TRUE(test::eventually([&] { return finish_work(state); }));
    const ComparisonWords& words = state.comparison->words;
    EXPECT_EQ(words.picture, "mine.png");
    EXPECT_EQ(words.size, (PictureSize{60, 40}));
    ASSERT_FALSE(words.verdict.empty());
    EXPECT_NE(words.verdict[0].find("upside down"), std::string::npos);
    EXPECT_EQ(words.examples.size(), 3U);
    ASSERT_TRUE(state.comparison->difference && state.comparison->found && state.comparison->right);
    state.comparison->view.picture = ComparedPicture::found;
    EXPECT_EQ(state.comparison->shown(), state.comparison->found);
    const Image& right = *state.comparison->right;
    const Image& found = *state.comparison->found;
    int as_expected = 0;
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 60; ++x) {
            EXPECT_TRUE(std::equal(right.at(x, y), right.at(x, y) + 3, found.at(x, 39 - y))) << x << "," << y;
            const bool equal = std::equal(right.at(x, y), right.at(x, y) + 3, found.at(x, y));
            EXPECT_EQ(words.at({x, y}).ends_with("as expected"), equal) << words.at({x, y});
            as_expected += equal ? 1 : 0;
        }
    }
    EXPECT_GT(as_expected, 100);
    EXPECT_EQ(words.at(words.examples[0].pixel), words.examples[0].words);

    state.comparison.reset();
    folder.write("broken.png", "no picture");
    compare("broken.png");
    EXPECT_FALSE(state.comparison);
    ASSERT_FALSE(state.dialogs.empty());
    EXPECT_NE(std::get<Question>(state.dialogs.back()).text.find("broken.png"), std::string::npos);
}

// As the comparison itself does: with a transparent background alpha 0 is background, whatever colour stands beside it.
TEST_F(Inspecting, ComparesAlphaUnderThePointer) {
    state.background = Background{.color = {}, .transparent = true};
    write_picture("opaque.png", false);
    const Image opaque = decode_png(folder.read("opaque.png"), "opaque.png");
    Image image(60, 40, 4);
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 60; ++x) {
            const std::uint8_t* rgb = opaque.at(x, y);
            const bool is_background = rgb[0] + rgb[1] + rgb[2] == 0;
            std::copy_n(rgb, 3, image.at(x, y));
            image.at(x, y)[0] = is_background ? 7 : rgb[0];
            image.at(x, y)[3] = is_background ? 0 : 255;
        }
    }
    const std::vector<std::uint8_t> sphere(image.at(30, 18), image.at(30, 18) + 4);
    ASSERT_EQ(sphere, (std::vector<std::uint8_t>{255, 0, 0, 255}));
    image.at(30, 18)[3] = 128;
    image.at(0, 0)[3] = 255;
    folder.write("mine.png", encode_png(image));
    compare("mine.png");
    ASSERT_TRUE(state.comparison && state.comparison->words.at);
    const auto at = state.comparison->words.at;
    EXPECT_EQ(at({1, 0}), "pixel 1,0: 0 0 0 (the background), as expected");
    EXPECT_EQ(at({30, 17}), "pixel 30,17: 255 0 0 (sphere 0), as expected");
    EXPECT_EQ(at({30, 18}), "pixel 30,18: found 255 0 0 with alpha 128 (sphere 0), expected 255 0 0 with alpha 255 (sphere 0)");
    EXPECT_EQ(at({0, 0}),
              "pixel 0,0: found 7 0 0 with alpha 255 (a colour of nothing in the scene), expected 0 0 0 with alpha 0 (the "
              "background)");
    EXPECT_EQ(state.comparison->words.counts, "2 of 2,400 pixels differ from the right picture.");
}

}  // namespace sphereview

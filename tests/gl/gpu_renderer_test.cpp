// The GPU renderer in this process: its numbers, and the colours that its window shader makes of them.
#include "gpu/gpu_renderer.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "exact/resolve.hpp"
#include "gl/contexts.hpp"
#include "shade/picture_shader.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

// Every colour value occurs; every third sphere is hidden.
Scene colorful_scene() {
    Scene scene;
    for (int i = 0; i < 256; ++i) {
        const auto value = static_cast<std::uint8_t>(i);
        Sphere sphere;
        sphere.center = {-90.0 + 12.0 * (i % 16), -90.0 + 12.0 * (i / 16), 200.0};
        sphere.radius = 6.5;
        sphere.color = {value, static_cast<std::uint8_t>(255 - i), static_cast<std::uint8_t>(i * 7)};
        sphere.hidden = i % 3 == 2;
        scene.spheres.push_back(sphere);
    }
    return scene;
}

class GpuRendererTest : public InContext {
protected:
    // What trace() gives for the block, as the scene's numbers of its best guesses: what a window shows.
    std::vector<std::int32_t> trace(const Scene& scene, PictureSize size, const Block& block) {
        drawn_ = drawn_spheres(scene);
        gpu_.upload(drawn_, build_lists(drawn_, scene.camera, size, gpu_tile_costs), scene.camera, size, timings_);
        std::vector<std::int32_t> visible(static_cast<std::size_t>(block.width * block.height));
        gpu_.trace(block, visible, timings_);
        Resolver(scene, drawn_, size).accept_guesses(visible);
        return visible;
    }

    Timings timings_;
    GpuRenderer gpu_{timings_};
    DrawnSpheres drawn_;
};

// A picture of any kind as RGBA.
std::vector<std::uint8_t> rgba_bytes(const Image& picture) {
    std::vector<std::uint8_t> bytes;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const std::uint8_t* pixel = picture.at(x, y);
            bytes.insert(bytes.end(), pixel, pixel + 3);
            bytes.push_back(picture.channels() == 4 ? pixel[3] : 255);
        }
    }
    return bytes;
}

TEST_P(GpuRendererTest, ShadesAWindowExactlyAsAnExport) {
    const Scene scene = colorful_scene();
    const std::vector<Background> backgrounds = {
        {{0, 0, 0}, false}, {{255, 255, 255}, false}, {{1, 128, 254}, false}, {{0, 0, 0}, true}};
    // Large first: later pictures use a part of the larger target.
    for (const PictureSize size : {PictureSize{320, 240}, PictureSize{99, 201}, PictureSize{1, 1}}) {
        const Block whole{0, 0, size.width, size.height};
        const std::vector<std::int32_t> visible = trace(scene, size, whole);
        for (const Background& background : backgrounds) {
            Image expected = make_picture(size, background);
            PictureShader(scene, scene.camera, size, Shading::flat, background).shade(whole, visible, expected);
            const Image shaded = gpu_.shade(scene, drawn_, background);
            ASSERT_EQ(shaded.width(), size.width);
            ASSERT_EQ(shaded.height(), size.height);
            EXPECT_TRUE(std::ranges::equal(shaded.bytes(), rgba_bytes(expected))) << size.width << "x" << size.height;
        }
        if (size.width == 1) continue;
        EXPECT_TRUE(std::ranges::count(visible, visible_background) > 0);
        EXPECT_TRUE(std::ranges::find(visible, 0) != visible.end() && std::ranges::find(visible, 255) != visible.end());
        EXPECT_EQ(std::ranges::find(visible, 2), visible.end());  // hidden
    }
}

TEST_P(GpuRendererTest, TracesBlocksThatJoinToTheWholePicture) {
    const Scene scene = colorful_scene();
    const PictureSize size{90, 70};
    const std::vector<std::int32_t> whole = trace(scene, size, {0, 0, 90, 70});
    for (const Block& block : {Block{0, 0, 90, 33}, Block{17, 33, 60, 30}, Block{89, 69, 1, 1}, Block{0, 69, 90, 1}}) {
        const std::vector<std::int32_t> part = trace(scene, size, block);
        for (int y = 0; y < block.height; ++y) {
            const auto row = whole.begin() + (block.y + y) * size.width + block.x;
            EXPECT_TRUE(std::equal(row, row + block.width, part.begin() + y * block.width)) << "row " << block.y + y;
        }
    }
}

// Wherever the spheres and lists are, the shaders find the same ones.
TEST_P(GpuRendererTest, TracesTheSameFromEveryKindOfTexture) {
    Scene scene;
    for (int i = 0; i < 5000; ++i) {
        scene.spheres.push_back(
            {{(i * 37 % 1000 - 500) * 0.2, (i * 61 % 999 - 499) * 0.2, 200.0 + i % 100}, 1.0 + i % 7, {}, false});
    }
    const DrawnSpheres drawn = drawn_spheres(scene);
    const PictureSize size{300, 200};
    const CandidateLists lists = build_lists(drawn, scene.camera, size, gpu_tile_costs);
    const auto traced_by = [&](GpuRenderer& gpu) {
        gpu.upload(drawn, lists, scene.camera, size, timings_);
        std::vector<std::int32_t> visible(300 * 200);
        gpu.trace({0, 0, 300, 200}, visible, timings_);
        return visible;
    };
    const std::vector<std::int32_t> from_buffers = traced_by(gpu_);
    EXPECT_EQ(gpu_.storage(), "buffer textures");
    GpuRenderer in_two_dimensions(timings_, {.in_buffer = 1000});
    EXPECT_TRUE(traced_by(in_two_dimensions) == from_buffers);
    EXPECT_EQ(in_two_dimensions.storage(), "2D textures");
    EXPECT_GT(std::ranges::count_if(from_buffers, [](std::int32_t number) { return number >= 0; }), 10'000);

    // A refusal says the figures, and leaves what was there.
    GpuRenderer small(timings_, {.in_buffer = 100, .side = 64});
    const DrawnSpheres few = drawn_spheres(colorful_scene());
    const CandidateLists few_lists = build_lists(few, {}, {{9, 9}}, gpu_tile_costs);
    small.upload(few, few_lists, {}, {9, 9}, timings_);
    try {
        small.upload(drawn, lists, scene.camera, size, timings_);
        ADD_FAILURE() << "no error";
    } catch (const TooLarge& error) {
        EXPECT_TRUE(contains(error.what(), "hold tables of 4,096 elements, the scene's 5,000 spheres need ")) << error.what();
    }
    std::vector<std::int32_t> visible(81);
    small.trace({0, 0, 9, 9}, visible, timings_);
    EXPECT_GT(std::ranges::count_if(visible, [](std::int32_t number) { return number >= 0; }), 10);
}

TEST_P(GpuRendererTest, TellsItsLimitsAndTheContextItsName) {
    EXPECT_GE(gpu_.uniform_capacity(), 1024);
    EXPECT_GE(gpu_.largest_block_side(), 1024);
    EXPECT_TRUE(context_->is_software()) << context_->renderer();  // these tests are for Mesa on the CPU
    const GlDescription gl = describe_gl();
    EXPECT_EQ(gl.renderer, context_->renderer());
    EXPECT_GE(gl.largest_uniform_block, gpu_.uniform_capacity() * 16);
}

TEST_P(GpuRendererTest, OwnersOfGlNamesMoveAndDelete) {
    GLuint name = 0;
    {
        Buffer first = Buffer::make();
        name = first.name();
        glBindBuffer(GL_UNIFORM_BUFFER, name);  // a name becomes an object when it is bound
        Buffer second = std::move(first);
        EXPECT_FALSE(first);
        EXPECT_EQ(second.name(), name);
        EXPECT_TRUE(glIsBuffer(name));
        second = Buffer::make();
        EXPECT_FALSE(glIsBuffer(name));
    }
    EXPECT_NO_THROW(check_gl("moving"));
}

INSTANTIATE_TEST_SUITE_P(Contexts, GpuRendererTest, testing::ValuesIn(context_kinds()), testing::PrintToStringParamName());

}  // namespace
}  // namespace sphereview::test

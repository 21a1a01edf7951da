// The GPU renderer in this process: its numbers, limits and names.
#include "gpu/gpu_renderer.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "gl/live_export.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

class GpuRendererTest : public InContext {
protected:
    Timings timings_;
    GpuRenderer gpu_{timings_};
};

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
    const DrawnSpheres few = drawn_spheres(colorful_scene(256));
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

// A window's picture beside what the export's renderer has for it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "exact/resolve.hpp"
#include "gl/contexts.hpp"
#include "gl/live.hpp"
#include "gpu/gpu_renderer.hpp"
#include "shade/picture_shader.hpp"
#include "tiles/pixel_range.hpp"

namespace sphereview::test {

// Spheres of all colours before the eye and beside the picture; every third is hidden.
inline Scene colorful_scene(int count) {
    Scene scene;
    for (int i = 0; i < count; ++i) {
        const auto value = static_cast<std::uint8_t>(i);
        Sphere sphere;
        sphere.center = {(i * 37 % 1000 - 500) * 0.25, (i * 61 % 999 - 499) * 0.25, 200.0 + i % 100};
        sphere.radius = 3.0 + i % 7;
        sphere.color = {value, static_cast<std::uint8_t>(255 - i), static_cast<std::uint8_t>(i * 7)};
        sphere.hidden = i % 3 == 2;
        scene.spheres.push_back(sphere);
    }
    return scene;
}

class LiveAndExported : public InContext {
protected:
    // The numbers that the export's renderer has for the picture, its best guesses for doubtful pixels: what a window shows.
    std::vector<std::int32_t> numbers(const Scene& scene, const View& view) {
        Timings timings;
        GpuRenderer gpu(timings);
        const DrawnSpheres drawn = drawn_spheres(scene, view.camera);
        gpu.upload(drawn, build_lists(drawn, view.camera, view.size, gpu_tile_costs), view.camera, view.size, timings);
        const int side = gpu.largest_block_side();
        std::vector<std::int32_t> all(static_cast<std::size_t>(view.size.width) * static_cast<std::size_t>(view.size.height));
        for (int y = 0; y < view.size.height; y += side) {
            for (int x = 0; x < view.size.width; x += side) {
                const Block block{x, y, std::min(side, view.size.width - x), std::min(side, view.size.height - y)};
                std::vector<std::int32_t> part(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
                gpu.trace(block, part, timings);
                for (int row = 0; row < block.height; ++row) {
                    std::copy_n(part.begin() + std::ptrdiff_t{row} * block.width, block.width,
                                all.begin() + std::ptrdiff_t{y + row} * view.size.width + x);
                }
            }
        }
        Resolver(scene, drawn, view.size).accept_guesses(all);
        return all;
    }

    Image exported(const Scene& scene, const View& view) { return colored(scene, view, numbers(scene, view)); }

    // The colours of those numbers.
    static Image colored(const Scene& scene, const View& view, const std::vector<std::int32_t>& numbers) {
        Image image(view.size.width, view.size.height, 4);
        PictureShader(scene, view.camera, view.size, Shading::flat, scene.background)
            .shade({0, 0, view.size.width, view.size.height}, numbers, image);
        return image;
    }
};

// The picture shows what is expected at the pixels that are traced. Of a doubtful pixel a window shows a guess, which may be
// another with other lists.
inline void expect_shown(LivePicture& picture, const Document& document, const View& view, int step, const Image& expected) {
    const DrawnSpheres drawn = drawn_spheres(document.scene(), view.camera);
    const PixelGrid grid{view.size, step};
    const Image image = shown(picture, document, view, step);
    for (int y = 0; y < view.size.height; ++y) {
        for (int x = 0; x < view.size.width; ++x) {
            const bool traced = grid.traced_column(x / step) == x && grid.traced_row(y / step) == y;
            if (!traced || at(image, x, y) == at(expected, x, y)) continue;
            ASSERT_NE(decision_level(document.scene(), drawn, view.camera, view.size, {x, y}), DecisionLevel::in_float)
                << x << "," << y;
        }
    }
}

// What is picked at every so many rows, and 5 columns, is what an export decides.
inline void expect_picked(LivePicture& picture, const Document& document, const View& view, int rows) {
    const DrawnSpheres drawn = drawn_spheres(document.scene(), view.camera);
    const Resolver resolver(document.scene(), drawn, view.camera, view.size, nullptr);
    DecisionLevel level{};
    for (int y = 0; y < view.size.height; y += rows) {
        for (int x = y % 5; x < view.size.width; x += 5) {
            ASSERT_EQ(picture.pick(document, {x, y}), resolver.resolve({x, y}, level)) << x << "," << y;
        }
    }
}

}  // namespace sphereview::test

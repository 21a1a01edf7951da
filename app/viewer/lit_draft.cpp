#include "viewer/lit_draft.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "light/lighting.hpp"
#include "shade/picture_shader.hpp"

namespace sphereview {

namespace {

// Lists for each light are worth their time for many points, which take some 100 bytes each.
constexpr int most_points = 1 << 20;

// A guess that is no hit at all becomes the background: nobody can say where the light would fall.
std::int32_t believed(const Scene& scene, const DrawnSpheres& drawn, const HitPlaces& places, Pixel pixel, std::int32_t seen) {
    if (!is_doubtful(seen)) return seen;
    const std::int32_t guess = doubtful(seen);
    if (guess < 0) return visible_background;
    const auto index = drawn.index_of(static_cast<std::uint32_t>(guess));
    const Sphere& sphere = scene.spheres[static_cast<std::size_t>(guess)];
    return index && std::isfinite(places.at(pixel, sphere, drawn.side(*index)).error) ? guess : visible_background;
}

}  // namespace

Image lit_draft(const Scene& scene, const PictureOptions& options, std::span<const std::int32_t> seen,
                const std::function<void(Image)>& show) {
    const auto& [width, height] = options.size;
    const int rows = std::clamp(most_points / width, 1, height);
    Light light = options.light;
    // Light by light where all is lit at once; a larger picture is lit part by part.
    const bool grows = rows == height;
    const bool finishes = options.samples > 1;  // nobody sees it with more lights
    light.lights = grows && finishes ? sky_lights(options.light, scene.spheres.size(), options.samples) : fewest_lights;

    const DrawnSpheres drawn = drawn_spheres(scene, options.camera);
    const HitPlaces places(options.camera, options.size);
    const Lighting lighting(scene, drawn, options.camera, options.size, 1, light);
    const PictureShader shader(scene, options.camera, options.size, Shading::studio, options.background);
    Image picture = make_picture(options.size, options.background);
    for (int y = 0; y < height; y += rows) {
        const Block block{0, y, width, std::min(rows, height - y)};
        const auto begin = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        std::vector<std::int32_t> visible(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
        for (std::size_t i = 0; i < visible.size(); ++i) {
            const auto place = static_cast<int>(i);
            visible[i] = believed(scene, drawn, places, {place % width, y + place / width}, seen[begin + i]);
        }
        const LightPreviews previews{.show = [&](std::span<const LightVector> some) {
            shader.shade(block, visible, picture, {}, some);
            show(picture.copy());
        }};
        shader.shade(block, visible, picture, {}, lighting.light(block, visible, nullptr, grows ? &previews : nullptr));
    }
    show(picture.copy());
    return picture;
}

}  // namespace sphereview

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

int rows_at_once(PictureSize size) { return std::clamp(most_points / size.width, 1, size.height); }

}  // namespace

PictureOptions draft_options(const Scene& scene, PictureOptions options) {
    // Light by light where all is lit at once; a larger picture is lit part by part.
    const bool grows = rows_at_once(options.size) == options.size.height;
    const bool finishes = options.samples > 1;  // nobody sees it with more lights
    options.light.lights = grows && finishes ? sky_lights(options.light, scene.spheres.size(), options.samples) : fewest_lights;
    options.samples = 1;
    return options;
}

Image lit_draft(const Scene& scene, const PictureOptions& picture_options, std::span<const std::int32_t> seen,
                const std::function<void(Image)>& show, KeptLight* kept) {
    const PictureOptions options = draft_options(scene, picture_options);
    const auto& [width, height] = options.size;
    const int rows = rows_at_once(options.size);
    const bool grows = rows == height;

    const DrawnSpheres drawn = drawn_spheres(scene, options.camera);
    const HitPlaces places(options.camera, options.size);
    const Lighting lighting(scene, drawn, options.camera, options.size, 1, options.light);
    if (kept != nullptr) kept->begin(lighting.sets(), 1);
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
        shader.shade(block, visible, picture, {}, lighting.light(block, visible, nullptr, grows ? &previews : nullptr, kept));
    }
    if (kept != nullptr) kept->finish();
    show(picture.copy());
    return picture;
}

}  // namespace sphereview

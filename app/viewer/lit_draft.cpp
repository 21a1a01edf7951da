#include "viewer/lit_draft.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/resolve.hpp"
#include "light/hit_places.hpp"
#include "light/lighting.hpp"
#include "shade/picture_shader.hpp"

namespace sphereview {

namespace {

// Lists for each light are worth their time for many points, which take some 100 bytes each.
constexpr int most_points = 1 << 20;

// The spheres that may be tried, all together, to decide pixels of which there is no guess: a fraction of a second.
constexpr std::size_t most_tried = 10'000'000;

// What the window's picture shows, where its guesses are hits: else nobody can say where the light falls. Such pixels are at the
// edge of a sphere and see another one behind it, or the background; as long as there is time they are decided.
class Believed {
public:
    Believed(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size)
        : scene_(scene), drawn_(drawn), places_(camera, size), resolver_(scene, drawn, camera, size, nullptr) {}

    std::int32_t operator()(Pixel pixel, std::int32_t seen) {
        if (!is_doubtful(seen)) return seen;
        const std::int32_t guess = doubtful(seen);
        if (guess < 0) return visible_background;
        if (is_hit(pixel, guess)) return guess;
        tried_ += drawn_.size();
        if (tried_ > most_tried) return visible_background;
        DecisionLevel level{};
        return resolver_.resolve(pixel, level);
    }

private:
    bool is_hit(Pixel pixel, std::int32_t number) const {
        const auto index = drawn_.index_of(static_cast<std::uint32_t>(number));
        const Sphere& sphere = scene_.spheres[static_cast<std::size_t>(number)];
        return index && std::isfinite(places_.at(places_.ray(pixel), sphere, drawn_.side(*index)).error);
    }

    const Scene& scene_;
    const DrawnSpheres& drawn_;
    HitPlaces places_;
    Resolver resolver_;
    std::size_t tried_ = 0;
};

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
    Believed believed(scene, drawn, options.camera, options.size);
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
            visible[i] = believed({place % width, y + place / width}, seen[begin + i]);
        }
        // Few lights have hard shadows: the light that is missing counts as that of a free sky, as in the picture that moved.
        const auto show_some = [&](std::span<const LightVector> some, double missing) {
            shader.shade(block, visible, picture, {}, some, {options.light, missing});
            show(picture.copy());
        };
        const LightPreviews previews{.show = show_some, .as_bright = false};
        shader.shade(block, visible, picture, {}, lighting.light(block, visible, nullptr, grows ? &previews : nullptr, kept));
    }
    if (kept != nullptr) kept->finish();
    show(picture.copy());
    return picture;
}

}  // namespace sphereview

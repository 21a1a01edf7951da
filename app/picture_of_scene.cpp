#include "app/picture_of_scene.hpp"

#include <algorithm>
#include <functional>

#include "app/light_options.hpp"

namespace sphereview {

namespace {

// Where in depth the bar holds. It is not looked for without need: that takes time for millions of spheres.
glm::dvec3 middle_for_scale(const LoadedScene& loaded, const RenderOptions& options) {
    if (!options.scale_bar) return glm::dvec3(0.0);
    return loaded.middle ? *loaded.middle : bounds_of(loaded.scene).middle();
}

}  // namespace

PictureOptions picture_options(const LoadedScene& loaded, const RenderOptions& options) {
    const Scene& scene = loaded.scene;
    const Background background = options.background.value_or(scene.background);
    const bool shows_any = std::ranges::any_of(scene.spheres, std::not_fn(&Sphere::hidden));
    return {scene.camera,
            options.size,
            background,
            options.certify,
            options.samples,
            options.shading,
            with_options(scene, options.light),
            {options.axes, options.scale_bar && shows_any, middle_for_scale(loaded, options),
             options.legend ? loaded.look.coloring : std::nullopt, is_light(background)}};
}

}  // namespace sphereview

// From the options of `render` and a scene that was read to the options of one picture.
#pragma once

#include "app/load_scene.hpp"
#include "app/options.hpp"
#include "app/render_picture.hpp"

namespace sphereview {

// The picture by the scene's camera. Throws InputError for light that the scene cannot have.
PictureOptions picture_options(const LoadedScene& loaded, const RenderOptions& options);

}  // namespace sphereview

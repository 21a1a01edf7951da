// What the options of `render` ask for of a scene that is read.
#pragma once

#include "app/load_scene.hpp"
#include "app/options.hpp"
#include "app/render_picture.hpp"

namespace sphereview {

// The picture by the scene's camera. Throws InputError for light that the scene cannot have.
PictureOptions picture_options(const LoadedScene& loaded, const RenderOptions& options);

}  // namespace sphereview

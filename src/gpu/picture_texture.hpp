// Pictures as textures.
#pragma once

#include "gpu/gl_object.hpp"
#include "image/image.hpp"

namespace sphereview {

// Puts a picture into a texture, which is made if there is none; each texel is seen as it is. The picture is no larger than the
// context's textures.
void upload(const Image& picture, Texture& texture);

}  // namespace sphereview

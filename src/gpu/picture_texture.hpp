// Pictures as textures.
#pragma once

#include "gpu/gl_object.hpp"
#include "image/image.hpp"

namespace sphereview {

// Uploads a picture, at most as large as the context's textures, into a texture without filtering, which is made if empty.
void upload(const Image& picture, Texture& texture);

}  // namespace sphereview

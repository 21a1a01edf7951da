// A finished picture as the window's panels draw it: the difference of a comparison, or what an eye sees.
#pragma once

#include <imgui.h>

#include <memory>
#include <optional>

#include "gpu/gl_object.hpp"
#include "image/image.hpp"

namespace sphereview {

// A picture in the window's context, for ImGui, which draws it smaller than it is.
class PictureTexture {
public:
    // Nothing for no picture, and for one that is larger than the context's textures.
    std::optional<ImTextureID> follow(const std::shared_ptr<const Image>& picture);

private:
    std::shared_ptr<const Image> uploaded_{};
    Texture texture_;
};

}  // namespace sphereview

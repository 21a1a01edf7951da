// A finished picture for the window's panels: the difference of a comparison, or what an eye sees.
#pragma once

#include <imgui.h>

#include <memory>
#include <optional>

#include "gpu/gl_object.hpp"
#include "image/image.hpp"

namespace sphereview {

// A picture in the window's context, which ImGui draws at a smaller size.
class PictureTexture {
public:
    // The picture's texture; nothing for null and for a picture larger than textures can be.
    std::optional<ImTextureID> follow(const std::shared_ptr<const Image>& picture);

private:
    std::shared_ptr<const Image> uploaded_{};
    Texture texture_;
};

}  // namespace sphereview

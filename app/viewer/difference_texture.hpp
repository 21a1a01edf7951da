// The picture of a comparison's difference, as the window's panels draw it.
#pragma once

#include <imgui.h>

#include <memory>
#include <optional>

#include "gpu/gl_object.hpp"
#include "image/image.hpp"

namespace sphereview {

// The picture of a difference in the window's context, for ImGui.
class DifferenceTexture {
public:
    // Nothing for no picture, and for one that is larger than the context's textures.
    std::optional<ImTextureID> follow(const std::shared_ptr<const Image>& picture);

private:
    std::shared_ptr<const Image> uploaded_{};
    Texture texture_;
};

}  // namespace sphereview

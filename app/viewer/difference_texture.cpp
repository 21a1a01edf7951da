#include "viewer/difference_texture.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <type_traits>

#include "gpu/picture_texture.hpp"

namespace sphereview {

std::optional<ImTextureID> DifferenceTexture::follow(const std::shared_ptr<const Image>& picture) {
    if (!picture || std::max(picture->width(), picture->height()) > gl_limit(GL_MAX_TEXTURE_SIZE)) return std::nullopt;
    if (picture != uploaded_) {
        upload(*picture, texture_);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);  // it is shown smaller than it is
        uploaded_ = picture;
    }
    // A number in some releases of ImGui, a pointer in others.
    using Bits = std::conditional_t<sizeof(ImTextureID) == sizeof(std::uint64_t), std::uint64_t, std::uint32_t>;
    return std::bit_cast<ImTextureID>(Bits{texture_.name()});
}

}  // namespace sphereview

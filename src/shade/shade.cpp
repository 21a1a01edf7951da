#include "shade/shade.hpp"

#include <cassert>
#include <cstddef>

namespace sphereview {

Image make_picture(PictureSize size, const Background& background) {
    return {size.width, size.height, background.transparent ? 4 : 3};
}

void shade_flat(const Scene& scene, const Background& background, const Block& block, std::span<const std::int32_t> visible,
                Image& picture) {
    assert(visible.size() == static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
    const bool alpha = picture.channels() == 4;
    const std::uint8_t background_alpha = background.transparent ? 0 : 255;
#pragma omp parallel for schedule(static)
    for (int row = 0; row < block.height; ++row) {
        const std::int32_t* numbers = visible.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(block.width);
        std::uint8_t* out = picture.at(block.x, block.y + row);
        for (int column = 0; column < block.width; ++column) {
            const bool hit = numbers[column] >= 0;
            const Color color = hit ? scene.spheres[static_cast<std::size_t>(numbers[column])].color : background.color;
            *out++ = color.r;
            *out++ = color.g;
            *out++ = color.b;
            if (alpha) *out++ = hit ? 255 : background_alpha;
        }
    }
}

}  // namespace sphereview

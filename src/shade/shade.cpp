#include "shade/shade.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstring>

#include "base/parallel.hpp"

namespace sphereview {

Image make_picture(PictureSize size, const Background& background) {
    return {size.width, size.height, background.transparent ? 4 : 3};
}

namespace {

// Fills `count` pixels from `out` on with the `channels` bytes of `pixel`; doubling, because most runs are long.
void fill(std::uint8_t* out, std::size_t count, const std::uint8_t* pixel, std::size_t channels) {
    const std::size_t size = count * channels;
    std::memcpy(out, pixel, channels);
    for (std::size_t done = channels; done < size; done *= 2) std::memcpy(out + done, out, std::min(done, size - done));
}

}  // namespace

void shade_flat(const Scene& scene, const Background& background, const Block& block, std::span<const std::int32_t> visible,
                Image& picture, Pixel origin) {
    assert(visible.size() == static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
    const auto channels = static_cast<std::size_t>(picture.channels());
    const std::uint8_t background_alpha = background.transparent ? 0 : 255;
    parallel_for(static_cast<std::size_t>(block.height), [&](std::size_t row) {
        const std::int32_t* numbers = visible.data() + row * static_cast<std::size_t>(block.width);
        const std::int32_t* const end = numbers + block.width;
        std::uint8_t* out = picture.at(block.x - origin.x, block.y - origin.y + static_cast<int>(row));
        while (numbers != end) {
            const std::int32_t number = *numbers;
            const std::int32_t* const run_end = std::find_if(numbers, end, [=](std::int32_t other) { return other != number; });
            const Color color = number >= 0 ? scene.spheres[static_cast<std::size_t>(number)].color : background.color;
            const std::array<std::uint8_t, 4> pixel = {color.r, color.g, color.b,
                                                       number >= 0 ? std::uint8_t{255} : background_alpha};
            const auto count = static_cast<std::size_t>(run_end - numbers);
            fill(out, count, pixel.data(), channels);
            out += count * channels;
            numbers = run_end;
        }
    });
}

}  // namespace sphereview

// What the pixels of a live picture show, and why: for the mouse, the inspector, and lines that spheres hide.
#include <array>
#include <optional>
#include <vector>

#include "exact/resolve.hpp"
#include "gpu/kept_framebuffers.hpp"
#include "gpu/live_picture.hpp"
#include "tiles/pixel_range.hpp"

namespace sphereview {

// What the buffer is sure of.
std::optional<std::int32_t> LivePicture::traced_number(Pixel pixel) const {
    if (!traced_) return std::nullopt;
    const PixelGrid grid{view_.size, step_};
    const Block texel{pixel.x / step_, pixel.y / step_, 1, 1};
    if (grid.traced_column(texel.x) != pixel.x || grid.traced_row(texel.y) != pixel.y) return std::nullopt;
    const KeptFramebuffers kept;
    std::array<std::int32_t, 1> visible{};
    visible_.read(texel, visible);
    if (is_doubtful(visible[0])) return std::nullopt;
    return visible[0] < 0 ? visible[0] : scene_.drawn().number(static_cast<std::size_t>(visible[0]));
}

std::vector<std::int32_t> LivePicture::traced_indices() const {
    const KeptFramebuffers kept;
    const auto [width, height] = PixelGrid{view_.size, step_}.size();
    std::vector<std::int32_t> traced(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    visible_.read({0, 0, width, height}, traced);
    return traced;
}

std::int32_t LivePicture::number_of(std::int32_t index) const {
    return index < 0 ? index : scene_.drawn().number(static_cast<std::size_t>(index));
}

std::vector<std::int32_t> LivePicture::seen_numbers() const {
    if (!traced_ || step_ != 1) return {};
    std::vector<std::int32_t> seen = traced_indices();
    for (std::int32_t& one : seen) one = is_doubtful(one) ? doubtful(number_of(doubtful(one))) : number_of(one);
    return seen;
}

SeenTexels LivePicture::seen_texels() const {
    if (!traced_) return {};
    SeenTexels seen{step_, PixelGrid{view_.size, step_}.size().width, traced_indices()};
    for (std::int32_t& one : seen.numbers) one = number_of(is_doubtful(one) ? doubtful(one) : one);
    return seen;
}

// Whether the drawn spheres and the lists are the document's.
bool LivePicture::is_of(const Document& document) const {
    const ChangesSince changes = document.changes_since(revision_);
    return revision_ != 0 && !changes.order && !changes.geometry;
}

PixelLights LivePicture::explain_lights(const Document& document, Pixel pixel, std::int32_t visible, const NumberedLights& lights,
                                        std::size_t most_lines) const {
    const Scene& scene = document.scene();
    const auto of = [&](const DrawnSpheres& drawn) {
        return sphereview::explain_lights({scene, drawn, view_.camera, view_.size, pixel, visible}, lights, most_lines);
    };
    return is_of(document) ? of(scene_.drawn()) : of(drawn_spheres(scene, view_.camera));
}

std::size_t LivePicture::candidates(const Document& document, Pixel pixel) const {
    const CandidateLists* lists = lists_for_any_pixel();
    if (!is_of(document) || lists == nullptr) return document.scene().spheres.size();
    std::size_t count = 0;
    for (const TileLevel& level : lists->levels) count += lists->at(level, pixel.x, pixel.y).size();
    return count;
}

PixelExplanation LivePicture::explain(const Document& document, Pixel pixel, std::size_t most_passed) const {
    const Scene& scene = document.scene();
    const auto of = [&](const DrawnSpheres& drawn, const CandidateLists* lists) {
        return explain_pixel(scene, drawn, view_.camera, view_.size, pixel, lists, most_hits_explained, most_passed);
    };
    return is_of(document) ? of(scene_.drawn(), lists_for_any_pixel()) : of(drawn_spheres(scene, view_.camera), nullptr);
}

std::int32_t LivePicture::pick(const Document& document, Pixel pixel) {
    const PictureSize& size = view_.size;
    if (revision_ == 0 || pixel.x < 0 || pixel.y < 0 || pixel.x >= size.width || pixel.y >= size.height) return visible_background;
    DecisionLevel level = DecisionLevel::in_float;
    if (!is_of(document)) {
        const DrawnSpheres drawn = drawn_spheres(document.scene(), view_.camera);
        return Resolver(document.scene(), drawn, view_.camera, size, nullptr).resolve(pixel, level);
    }
    if (const auto number = traced_number(pixel)) return *number;
    return Resolver(document.scene(), scene_.drawn(), view_.camera, size, lists_for_any_pixel()).resolve(pixel, level);
}

}  // namespace sphereview

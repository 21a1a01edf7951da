#include "shade/picture_shader.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <mutex>
#include <optional>

#include "base/parallel.hpp"
#include "base/simd.hpp"
#include "base/square_root.hpp"
#include "scene/vectors.hpp"
#include "shade/brightness.hpp"

namespace sphereview {

namespace {

constexpr std::size_t most_at_once = 64;  // pixels

constexpr std::size_t shaded_at_once = 4096;
constexpr double smallest_radius = 0x1p-1021;  // its inverse is finite
constexpr int usual_scale = -3;                // shading_scale, as a power of two
constexpr int large = 900;                     // 2 to this and to its negative are far enough from the ends of double
constexpr double narrowest = 1.0 + 1.0 / 256.0;

// The squares must neither over- nor underflow.
double length(const glm::dvec3& v) {
    const double most = largest_of(v);
    if (most == 0.0) return 0.0;
    if (most > 1e-120 && most < 1e120) return square_root(dot(v, v));
    const glm::dvec3 u = v / most;
    return most * square_root(dot(u, u));
}

// A distance from the eye that would not overflow.
glm::dvec3 from_eye(const glm::dvec3& point, const glm::dvec3& eye) {
    return {shading_scale * point.x - shading_scale * eye.x, shading_scale * point.y - shading_scale * eye.y,
            shading_scale * point.z - shading_scale * eye.z};
}

// The same in lengths times a power of two.
glm::dvec3 from_eye(const glm::dvec3& point, const glm::dvec3& eye, int scale) {
    return scale == usual_scale ? from_eye(point, eye) : times_two_to(point, scale) - times_two_to(eye, scale);
}

// In which doubles can tell where a camera's parallel rays begin.
int scale_of_origins(const Camera& camera) { return -exponent_of(std::max(largest_of(camera.right), largest_of(camera.up))); }

// A sphere as its pixels need it.
struct ShadedSphere {
    glm::dvec3 center;  // relative to the eye
    double radius;
    double inverse_radius;
    double side;  // 1: the ray begins outside and hits at the near root; -1: inside or on the surface, at the far one
};

double side_of(EyeSide side) { return side == EyeSide::outside ? 1.0 : -1.0; }

ShadedSphere shaded_sphere(const Sphere& sphere, const glm::dvec3& eye, EyeSide side, int scale) {
    ShadedSphere shaded{};
    shaded.center = from_eye(sphere.center, eye, scale);
    shaded.radius = std::max(std::ldexp(sphere.radius, scale), smallest_radius);
    shaded.inverse_radius = 1.0 / shaded.radius;
    shaded.side = side_of(side);
    return shaded;
}

// A row's rays that meet one sphere, and what is asked of the hits.
struct Span {
    ShadedSphere sphere;
    glm::dvec3 first;  // forward + upward up
    glm::dvec3 right;
    bool orthographic = false;  // then: the direction, of length 1; and where the first ray of the row begins
    glm::dvec3 direction;
    double across = 0;  // of the first pixel; 2 more for each next
    std::size_t count = 0;
};

// For each pixel n.v, the distance, and the normal.
struct Hits {
    std::array<double, most_at_once> facing;
    std::array<double, most_at_once> distance;
    std::array<double, most_at_once> x;
    std::array<double, most_at_once> y;
    std::array<double, most_at_once> z;
};

// Also of what is no number: 0.
constexpr double between_0_and_1(double value) { return value > 0.0 ? (value < 1.0 ? value : 1.0) : 0.0; }

// The closest approach first, as in exact/filter.hpp: q is where it lies, in radii from the centre.
template <bool orthographic>
void find_hits_in(const Span& span, Hits& hits) {
    const glm::dvec3 center = span.sphere.center;
    const glm::dvec3 direction = span.direction;
    const glm::dvec3 first = span.first;
    const glm::dvec3 right = span.right;
    const double radius = span.sphere.radius;
    const double inverse_radius = span.sphere.inverse_radius;
    const double side = span.sphere.side;
    const double from = span.across;
    const int count = static_cast<int>(span.count);
    for (int i = 0; i < count; ++i) {
        const double across = from + 2.0 * i;
        const double dx = first.x + across * right.x;
        const double dy = first.y + across * right.y;
        const double dz = first.z + across * right.z;
        const double inverse_length = 1.0 / square_root(dx * dx + dy * dy + dz * dz);
        const double nx = orthographic ? direction.x : dx * inverse_length;
        const double ny = orthographic ? direction.y : dy * inverse_length;
        const double nz = orthographic ? direction.z : dz * inverse_length;
        const glm::dvec3 c = orthographic ? glm::dvec3(center.x - dx, center.y - dy, center.z - dz) : center;
        const double along = c.x * nx + c.y * ny + c.z * nz;
        const double qx = (c.x - along * nx) * inverse_radius;
        const double qy = (c.y - along * ny) * inverse_radius;
        const double qz = (c.z - along * nz) * inverse_radius;
        const double rest = 1.0 - (qx * qx + qy * qy + qz * qz);
        const double facing = square_root(rest > 0.0 ? rest : 0.0);  // grazing rays may pass by a little
        const auto at = static_cast<std::size_t>(i);
        hits.facing[at] = facing;
        hits.distance[at] = along - side * (facing * radius);
        hits.x[at] = -(side * qx) - facing * nx;
        hits.y[at] = -(side * qy) - facing * ny;
        hits.z[at] = -(side * qz) - facing * nz;
    }
}

SPHEREVIEW_FOR_EACH_SIMD void find_hits(const Span& span, Hits& hits) {
    if (span.orthographic) {
        find_hits_in<true>(span, hits);
    } else {
        find_hits_in<false>(span, hits);
    }
}

// The byte of a channel, 0..1.
std::uint8_t byte_of(double value) { return static_cast<std::uint8_t>(std::floor(255.0 * between_0_and_1(value) + 0.5)); }

std::uint8_t times(std::uint8_t channel, double factor) { return static_cast<std::uint8_t>(std::floor(channel * factor + 0.5)); }

// What is lit at all is not black, unless the sphere is: so a shadow's edge is seen however flat the light falls.
// `more`: brightness besides the light's.
Color lit_color(const Color& color, const glm::dvec3& normal, const LightVector& light, double more) {
    if (light == LightVector{} && more == 0.0) return {0, 0, 0};
    const double sum =
        normal.x * static_cast<double>(light.x) + normal.y * static_cast<double>(light.y) + normal.z * static_cast<double>(light.z);
    const double brightness = (sum > 0.0 ? sum / light_one : 0.0) + more;
    const double factor = between_0_and_1(shown_part(brightness));
    const auto channel = [&](std::uint8_t own) { return std::max(times(own, factor), std::min<std::uint8_t>(own, 1)); };
    return {channel(color.r), channel(color.g), channel(color.b)};
}

double brightness_of(const FreeSky& free, const glm::dvec3& normal, const CameraAxes& axes) {
    return free.part *
           brightness_of_free_sky(free.light, {dot(normal, axes.right), dot(normal, axes.up), -dot(normal, axes.ahead)});
}

// Fills `count` pixels from `out` on with the `channels` bytes of `pixel`; doubling, because most runs are long.
void fill(std::uint8_t* out, std::size_t count, const std::uint8_t* pixel, std::size_t channels) {
    const std::size_t size = count * channels;
    std::memcpy(out, pixel, 3);  // of a known size: no call
    if (channels == 4) out[3] = pixel[3];
    for (std::size_t done = channels; done < size; done *= 2) std::memcpy(out + done, out, std::min(done, size - done));
}

// What the hits of a sphere lie between. From outside none is beyond the silhouette.
DepthRange depths_in_perspective(const Sphere& sphere, const glm::dvec3& eye) {
    const double distance = length(from_eye(sphere.center, eye));
    const double radius = shading_scale * sphere.radius;
    // The silhouette is nearer than the centre.
    return {std::fabs(distance - radius), distance < radius ? distance + radius : distance};
}

// The depths of a sphere for rays that begin in the plane with the normal `ahead`. Nothing for a sphere behind the plane.
std::optional<DepthRange> depths_of_parallels(const Sphere& sphere, const glm::dvec3& eye, const glm::dvec3& ahead,
                                              const glm::dvec3& direction) {
    const double depth = dot(from_eye(sphere.center, eye), ahead);
    const double radius = shading_scale * sphere.radius;
    if (depth < -radius) return std::nullopt;
    const double steepness = dot(direction, ahead);
    const double rest = 1.0 - steepness * steepness;
    const double silhouette = depth + radius * square_root(rest > 0.0 ? rest : 0.0);
    return DepthRange{std::max(depth - radius, 0.0) / steepness, (depth < radius ? depth + radius : silhouette) / steepness};
}

}  // namespace

DepthRange depth_range(const Scene& scene, const Camera& camera) {
    constexpr double none = std::numeric_limits<double>::infinity();
    DepthRange range{none, 0.0};
    const glm::dvec3 ahead = camera_axes(camera).ahead;
    const glm::dvec3 direction = unit(0.5 * camera.center - 0.5 * camera.eye);
    const auto depths = [&](const Sphere& sphere) {
        return camera.orthographic() ? depths_of_parallels(sphere, camera.eye, ahead, direction)
                                     : depths_in_perspective(sphere, camera.eye);
    };
    std::mutex joining;
    parallel_pieces(scene.spheres.size(), shaded_at_once, [&](std::size_t begin, std::size_t end) {
        DepthRange part{none, 0.0};
        for (std::size_t i = begin; i < end; ++i) {
            const Sphere& sphere = scene.spheres[i];
            if (sphere.hidden) continue;
            if (const auto of_sphere = depths(sphere)) {
                part.nearest = std::min(part.nearest, of_sphere->nearest);
                part.farthest = std::max(part.farthest, of_sphere->farthest);
            }
        }
        const std::lock_guard lock(joining);
        range = {std::min(range.nearest, part.nearest), std::max(range.farthest, part.farthest)};
    });
    if (range.nearest == none) return {};
    range.farthest = std::max(range.farthest, std::min(range.nearest, 1e308) * narrowest);
    return range;
}

Image make_picture(PictureSize size, const Background& background) {
    return {size.width, size.height, background.transparent ? 4 : 3};
}

PictureShader::PictureShader(const Scene& scene, const Camera& camera, PictureSize size, Shading shading,
                             const Background& background)
    : scene_(scene), camera_(camera), sides_(camera), size_(size), shading_(shading), background_(background), scale_(usual_scale) {
    if (!depends_on_hit(shading)) return;
    rays_ = ray_basis<double>(camera, size, scale_);
    if (rays_.orthographic && rays_.reach == 0.0) {  // where the rays begin is beyond doubles of that scale
        const RayBasis<double> own = ray_basis<double>(camera, size, scale_of_origins(camera));
        if (own.reach > 0.0) {
            scale_ = scale_of_origins(camera);
            rays_ = own;
        }
    }
    axes_ = camera_axes(camera);
    if (shading == Shading::normal || is_lit(shading)) return;
    range_ = depth_range(scene, camera);
    inverse_range_ = 1.0 / (range_.farthest - range_.nearest);
}

void PictureShader::shade(const Block& block, std::span<const std::int32_t> visible, Image& picture, Pixel origin,
                          std::span<const LightVector> light, const FreeSky& free) const {
    assert(visible.size() == static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
    assert(light.size() == (is_lit(shading_) ? visible.size() : 0));
    const auto width = static_cast<std::size_t>(block.width);
    parallel_for(static_cast<std::size_t>(block.height), [&](std::size_t row) {
        const int y = block.y + static_cast<int>(row);
        shade_row(block.x, y, visible.subspan(row * width, width), light.empty() ? light : light.subspan(row * width, width), free,
                  picture.at(block.x - origin.x, y - origin.y), static_cast<std::size_t>(picture.channels()));
    });
}

Color PictureShader::color(Pixel pixel, std::int32_t visible, const LightVector& light) const {
    std::array<std::uint8_t, 3> bytes{};
    const std::span<const LightVector> lights(&light, is_lit(shading_) ? 1 : 0);
    shade_row(pixel.x, pixel.y, {&visible, 1}, lights, {}, bytes.data(), bytes.size());
    return {bytes[0], bytes[1], bytes[2]};
}

int PictureShader::scale_for(const Sphere& sphere) const {
    if (scale_ == usual_scale && shading_scale * sphere.radius >= smallest_radius) return usual_scale;
    const int exponent = exponent_of(sphere.radius);
    const int scale = std::ldexp(sphere.radius, scale_) < smallest_radius ? -large - exponent : scale_;
    // Beside a camera or at a distance that no scale has room for as well, doubles cannot tell where it is hit.
    const double farthest = std::max(largest_of(sphere.center), largest_of(camera_.eye));
    const bool fits = std::abs(exponent + scale) <= large && std::ldexp(farthest, scale) < 0x1p900;
    if (!fits) return usual_scale;
    return scale == scale_ || !rays_.orthographic || ray_basis<double>(camera_, size_, scale).reach > 0.0 ? scale : usual_scale;
}

void PictureShader::shade_row(int x, int y, std::span<const std::int32_t> visible, std::span<const LightVector> light,
                              const FreeSky& free, std::uint8_t* out, std::size_t channels) const {
    const double upward = static_cast<double>(ray_coefficients(size_, {x, y}).upward);
    Span span;
    span.first = {rays_.forward.x + upward * rays_.up.x, rays_.forward.y + upward * rays_.up.y,
                  rays_.forward.z + upward * rays_.up.z};
    span.right = rays_.right;
    const auto begin_rays = [&](const RayBasis<double>& rays) {
        span.first = upward * rays.up;
        span.right = rays.right;
    };
    int scale = scale_;
    if (rays_.orthographic) {
        span.orthographic = true;
        span.direction = unit_ray(rays_, size_, {x, y});
        begin_rays(rays_);
    }
    Hits hits;
    // The sphere's number; and the hit in `hits` and the pixel in the row, for the modes that depend on the hit.
    const auto color_of = [&](std::int32_t number, std::size_t k = 0, std::size_t column = 0) -> Color {
        const Sphere& sphere = scene_.spheres[static_cast<std::size_t>(number)];
        const auto depth = [&] {
            const double distance = scale == usual_scale ? hits.distance[k] : std::ldexp(hits.distance[k], usual_scale - scale);
            return between_0_and_1((distance - range_.nearest) * inverse_range_);
        };
        switch (shading_) {
            case Shading::flat: return sphere.color;
            case Shading::id: return id_color(static_cast<std::uint32_t>(number));
            case Shading::headlight: {
                const double factor = 0.3 + 0.7 * between_0_and_1(hits.facing[k]) / (1.0 + depth());
                return {times(sphere.color.r, factor), times(sphere.color.g, factor), times(sphere.color.b, factor)};
            }
            case Shading::normal: {
                const auto along = [&](const glm::dvec3& axis) {
                    return byte_of(0.5 + 0.5 * (hits.x[k] * axis.x + hits.y[k] * axis.y + hits.z[k] * axis.z));
                };
                return {along(axes_.right), along(axes_.up), along(-axes_.ahead)};
            }
            case Shading::depth: {
                const std::uint8_t grey = byte_of(1.0 - 0.8 * depth());
                return {grey, grey, grey};
            }
            case Shading::studio: {
                const glm::dvec3 normal{hits.x[k], hits.y[k], hits.z[k]};
                return lit_color(sphere.color, normal, light[column], free.part > 0.0 ? brightness_of(free, normal, axes_) : 0.0);
            }
        }
        return {};  // no such mode
    };
    const bool of_numbers = !depends_on_hit(shading_);
    for (auto run = visible.begin(); run != visible.end();) {
        const std::int32_t number = *run;
        const auto end = std::find_if(run, visible.end(), [=](std::int32_t other) { return other != number; });
        if (of_numbers || number < 0) {
            const auto count = static_cast<std::size_t>(end - run);
            const Color color = number < 0 ? background_.color : color_of(number);
            const bool clear = number < 0 && background_.transparent;
            const std::array<std::uint8_t, 4> pixel = {color.r, color.g, color.b, clear ? std::uint8_t{0} : std::uint8_t{255}};
            fill(out, count, pixel.data(), channels);
            out += count * channels;
            run = end;
            continue;
        }
        const Sphere& sphere = scene_.spheres[static_cast<std::size_t>(number)];
        const EyeSide side = sides_(sphere);
        if (const int own = scale_for(sphere); own != scale) {
            scale = own;
            if (rays_.orthographic) begin_rays(scale == scale_ ? rays_ : ray_basis<double>(camera_, size_, scale));
        }
        span.sphere = shaded_sphere(sphere, camera_.eye, side, scale);
        const std::size_t at_once = side == EyeSide::in_plane ? 1 : most_at_once;
        for (; run != end; run += static_cast<std::ptrdiff_t>(span.count)) {
            const Pixel first{x + static_cast<int>(run - visible.begin()), y};
            span.across = static_cast<double>(ray_coefficients(size_, first).across);
            span.count = std::min(static_cast<std::size_t>(end - run), at_once);
            if (side == EyeSide::in_plane) span.sphere.side = side_of(origin_side(sphere, side, camera_, size_, first));
            find_hits(span, hits);
            for (std::size_t k = 0; k < span.count; ++k, out += channels) {
                const Color color = color_of(number, k, static_cast<std::size_t>(run - visible.begin()) + k);
                const std::array<std::uint8_t, 4> bytes = {color.r, color.g, color.b, 255};
                std::copy_n(bytes.data(), channels, out);
            }
        }
    }
}

}  // namespace sphereview

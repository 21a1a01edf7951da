// The fastest known way to draw many spheres on a CPU, to measure against: Embree's own sphere geometry, packets of eight rays,
// all cores, the text format read in parallel, and this project's PNG encoder. In float, so some pixels at the edges differ.
// Single rays are slower; packets of sixteen, rows of eight, and other build qualities and
// flags make no difference. With a number of lights: lit by so many directions of `--shade studio`, the very same, a packet of
// shadow rays for each, where any of its points face the light. usage: embree_peer SCENE.txt OUT.png [LIGHTS]
#include <embree3/rtcore.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "base/output_file.hpp"
#include "image/png.hpp"
#include "light/light_set.hpp"
#include "scene/vectors.hpp"
#include "shade/brightness.hpp"

namespace {

constexpr int side = 1000;  // of the picture, in pixels
constexpr int packet_width = 4;
constexpr int packet_height = 2;
constexpr std::size_t numbers_a_sphere = 7;

[[noreturn]] void fail(const char* what) {
    std::fprintf(stderr, "embree_peer: %s\n", what);
    std::_Exit(2);
}

// Mapped: nothing truncates the benchmark's files.
std::string_view map_file(const char* path) {
    const auto size = std::filesystem::file_size(path);
    void* data = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, open(path, O_RDONLY), 0);
    if (data == MAP_FAILED) fail("the scene cannot be mapped");
    return {static_cast<const char*>(data), size};
}

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

template <typename Number>
Number number_in(const char*& at, const char* end) {
    while (at != end && is_space(*at)) ++at;
    Number number{};
    const auto [stop, error] = std::from_chars(at, end, number);
    if (error != std::errc()) fail("the scene holds something that is no number");
    at = stop;
    return number;
}

struct Scene {
    RTCGeometry geometry;
    std::unique_ptr<std::uint8_t[]> colors;  // red, green, blue of each sphere
};

Scene read_scene(RTCDevice device, std::string_view text) {
    const char* at = text.data();
    const char* const end = at + text.size();
    const auto count = number_in<std::size_t>(at, end);
    Scene scene{rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT), std::make_unique_for_overwrite<std::uint8_t[]>(3 * count)};
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(scene.geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                                                 4 * sizeof(float), count));  // x, y, z, radius

    // Parts that end where a number does; how many numbers lie before each says where its spheres belong.
    constexpr std::size_t part_bytes = 1 << 18;
    std::vector<const char*> parts;
    while (at < end) {
        parts.push_back(at);
        at += std::min<std::ptrdiff_t>(part_bytes, end - at);
        while (at != end && !is_space(*at)) ++at;
    }
    parts.push_back(end);
    std::vector<std::size_t> first(parts.size());
    tbb::parallel_for(std::size_t{1}, parts.size(), [&](std::size_t part) {
        std::size_t numbers = 0;
        for (const char* c = parts[part - 1]; c + 1 < parts[part]; ++c) numbers += is_space(c[0]) && !is_space(c[1]);
        first[part] = numbers;
    });
    for (std::size_t part = 1; part < first.size(); ++part) first[part] += first[part - 1];
    if (first.back() != numbers_a_sphere * count) fail("the scene holds more or fewer numbers than it says");
    tbb::parallel_for(std::size_t{1}, parts.size(), [&](std::size_t part) {
        const char* c = parts[part - 1];
        for (std::size_t number = first[part - 1]; number < first[part]; ++number) {
            const std::size_t sphere = number / numbers_a_sphere;
            const std::size_t member = number % numbers_a_sphere;  // R G B, x y z, radius
            if (member < 3) {
                scene.colors[3 * sphere + member] = number_in<std::uint8_t>(c, parts[part]);
            } else {
                vertices[4 * sphere + member - 3] = number_in<float>(c, parts[part]);
            }
        }
    });
    return scene;
}

alignas(32) constexpr int all_rays[8] = {-1, -1, -1, -1, -1, -1, -1, -1};

RTCIntersectContext coherent() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    return context;
}

// A light as floats: its direction, of length 1, and what it adds.
struct FloatLight {
    std::array<float, 3> direction;
    std::array<float, 3> share;
};

std::vector<FloatLight> lights_of(int count) {
    std::vector<FloatLight> lights;
    for (const sphereview::DirectedLight& light : sphereview::light_set({}, count, {}, 0)) {
        const glm::dvec3 l = sphereview::unit(light.direction);
        const auto part = [](std::int32_t share) { return static_cast<float>(share / sphereview::light_one); };
        lights.push_back({{static_cast<float>(l.x), static_cast<float>(l.y), static_cast<float>(l.z)},
                          {part(light.share.x), part(light.share.y), part(light.share.z)}});
    }
    return lights;
}

// How bright the points of a packet are, that were hit.
std::array<float, 8> brightness(RTCScene scene, const RTCRayHit8& rays, std::span<const FloatLight> lights) {
    constexpr float off_the_surface = 1e-4F;  // of the distance
    std::array<float, 8> bright{};
    std::array<std::array<float, 8>, 3> normal{};
    RTCRay8 points{};
    for (std::size_t k = 0; k < 8; ++k) {
        const float length = std::sqrt(rays.hit.Ng_x[k] * rays.hit.Ng_x[k] + rays.hit.Ng_y[k] * rays.hit.Ng_y[k] +
                                       rays.hit.Ng_z[k] * rays.hit.Ng_z[k]);
        normal[0][k] = rays.hit.Ng_x[k] / length;
        normal[1][k] = rays.hit.Ng_y[k] / length;
        normal[2][k] = rays.hit.Ng_z[k] / length;
        points.org_x[k] = rays.ray.tfar[k] * rays.ray.dir_x[k];
        points.org_y[k] = rays.ray.tfar[k] * rays.ray.dir_y[k];
        points.org_z[k] = rays.ray.tfar[k] * rays.ray.dir_z[k];
        points.tnear[k] = off_the_surface * points.org_z[k];
        points.mask[k] = ~0U;
    }
    RTCIntersectContext context = coherent();
    for (const FloatLight& light : lights) {
        alignas(32) std::array<int, 8> facing{};
        int any = 0;
        for (std::size_t k = 0; k < 8; ++k) {
            const bool hit = rays.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
            const float along =
                normal[0][k] * light.direction[0] + normal[1][k] * light.direction[1] + normal[2][k] * light.direction[2];
            facing[k] = hit && along > 0.0F ? -1 : 0;
            any |= facing[k];
            points.dir_x[k] = light.direction[0];
            points.dir_y[k] = light.direction[1];
            points.dir_z[k] = light.direction[2];
            points.tfar[k] = std::numeric_limits<float>::infinity();
        }
        if (any == 0) continue;
        rtcOccluded8(facing.data(), scene, &context, &points);
        for (std::size_t k = 0; k < 8; ++k) {
            const float along = normal[0][k] * light.share[0] + normal[1][k] * light.share[1] + normal[2][k] * light.share[2];
            bright[k] += facing[k] != 0 && points.tfar[k] > 0.0F ? along : 0.0F;
        }
    }
    return bright;
}

// From the eye at 0 through the square from (-50, -50, 100) to (50, 50, 100); row 0 is on top.
void trace_packet(RTCScene scene, const std::uint8_t* colors, std::span<const FloatLight> lights, int left, int top,
                  sphereview::Image& picture) {
    RTCIntersectContext context = coherent();
    RTCRayHit8 rays{};
    for (int k = 0; k < 8; ++k) {
        rays.ray.dir_x[k] = static_cast<float>(50.0 / side * (2 * (left + k % packet_width) + 1 - side));
        rays.ray.dir_y[k] = static_cast<float>(50.0 / side * (side - 1 - 2 * (top + k / packet_width)));
        rays.ray.dir_z[k] = 100.0F;
        rays.ray.tfar[k] = std::numeric_limits<float>::infinity();
        rays.ray.mask[k] = ~0U;
        rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(all_rays, scene, &context, &rays);
    const std::array<float, 8> bright = lights.empty() ? std::array<float, 8>{} : brightness(scene, rays, lights);
    for (int k = 0; k < 8; ++k) {
        const bool hit = rays.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
        const std::uint8_t* color = colors + 3 * static_cast<std::size_t>(rays.hit.primID[k]);
        const auto e = static_cast<double>(bright[static_cast<std::size_t>(k)]);
        const double part = lights.empty() ? 1.0 : std::min(sphereview::shown_part(e), 1.0);
        std::uint8_t* pixel = picture.at(left + k % packet_width, top + k / packet_width);
        for (int channel = 0; channel < 3; ++channel) {
            pixel[channel] = hit ? static_cast<std::uint8_t>(part * color[channel] + 0.5) : std::uint8_t{0};
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3 && argc != 4) fail("usage: embree_peer SCENE.txt OUT.png [LIGHTS]");
    const std::vector<FloatLight> lights = argc == 4 ? lights_of(std::atoi(argv[3])) : std::vector<FloatLight>{};
    RTCDevice device = rtcNewDevice(nullptr);
    const Scene read = read_scene(device, map_file(argv[1]));
    rtcCommitGeometry(read.geometry);
    RTCScene scene = rtcNewScene(device);
    rtcAttachGeometry(scene, read.geometry);
    rtcCommitScene(scene);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) fail("Embree failed");

    sphereview::Image picture(side, side, 3);
    const tbb::blocked_range2d<int> packets(0, side / packet_height, 0, side / packet_width);  // divided into tiles
    tbb::parallel_for(packets, [&](const tbb::blocked_range2d<int>& tile) {
        for (int row = tile.rows().begin(); row < tile.rows().end(); ++row) {
            for (int column = tile.cols().begin(); column < tile.cols().end(); ++column) {
                trace_packet(scene, read.colors.get(), lights, column * packet_width, row * packet_height, picture);
            }
        }
    });
    sphereview::write_output(argv[2], sphereview::encode_png(picture));
    std::_Exit(0);  // nothing is gained by freeing a million spheres first
}

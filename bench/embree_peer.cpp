// The fastest known way to draw many spheres on a CPU, to measure against: Embree's own sphere geometry, packets of eight rays,
// all cores, the text format read in parallel, and this project's PNG encoder. In float, so some pixels at the edges differ.
// Single rays are slower; packets of sixteen, rows of eight, and other build qualities and
// flags make no difference.
// usage: embree_peer SCENE.txt OUT.png
#include <embree3/rtcore.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

#include "base/output_file.hpp"
#include "image/png.hpp"

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

// From the eye at 0 through the square from (-50, -50, 100) to (50, 50, 100); row 0 is on top.
void trace_packet(RTCScene scene, const std::uint8_t* colors, int left, int top, sphereview::Image& picture) {
    alignas(32) static constexpr int all[8] = {-1, -1, -1, -1, -1, -1, -1, -1};
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    RTCRayHit8 rays{};
    for (int k = 0; k < 8; ++k) {
        rays.ray.dir_x[k] = static_cast<float>(50.0 / side * (2 * (left + k % packet_width) + 1 - side));
        rays.ray.dir_y[k] = static_cast<float>(50.0 / side * (side - 1 - 2 * (top + k / packet_width)));
        rays.ray.dir_z[k] = 100.0F;
        rays.ray.tfar[k] = std::numeric_limits<float>::infinity();
        rays.ray.mask[k] = ~0U;
        rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(all, scene, &context, &rays);
    for (int k = 0; k < 8; ++k) {
        const bool hit = rays.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
        const std::uint8_t* color = colors + 3 * static_cast<std::size_t>(rays.hit.primID[k]);
        std::uint8_t* pixel = picture.at(left + k % packet_width, top + k / packet_width);
        for (int channel = 0; channel < 3; ++channel) pixel[channel] = hit ? color[channel] : std::uint8_t{0};
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) fail("usage: embree_peer SCENE.txt OUT.png");
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
                trace_packet(scene, read.colors.get(), column * packet_width, row * packet_height, picture);
            }
        }
    });
    sphereview::write_output(argv[2], sphereview::encode_png(picture));
    std::_Exit(0);  // nothing is gained by freeing a million spheres first
}

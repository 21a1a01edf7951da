// What light costs: all lights of a picture whose visible spheres are known, on all cores.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "cost.hpp"
#include "cpu/cpu_renderer.hpp"
#include "exact/resolve.hpp"
#include "light/lighting.hpp"
#include "random_scene.hpp"

namespace {

using namespace sphereview;

constexpr PictureSize size{1000, 1000};
constexpr Block whole_picture{0, 0, size.width, size.height};

}  // namespace

int main(int argc, char** argv) {
    const auto set = argc == 5 ? scene_set_named(argv[1]) : std::nullopt;
    if (!set) {
        std::fprintf(stderr, "usage: lights volume|half COUNT LIGHTS RUNS: one JSON line on standard output\n");
        return 2;
    }
    const std::size_t count = std::strtoul(argv[2], nullptr, 10);
    const int lights = std::clamp(std::atoi(argv[3]), fewest_lights, most_lights);
    const int runs = std::max(1, std::atoi(argv[4]));
    const Scene scene = random_scene(*set, count);
    const DrawnSpheres drawn = drawn_spheres(scene);
    std::vector<std::int32_t> visible(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    const CandidateLists lists = build_lists(drawn, scene.camera, size, cpu_tile_costs);
    CpuRenderer(drawn, lists, scene.camera, size).trace(whole_picture, visible);
    Resolver(scene, drawn, size, &lists).certify(whole_picture, visible);

    std::printf("{\"set\": \"%s\", \"count\": %zu, \"lights\": %d, ", argv[1], count, lights);
    print("light", median_cost(runs, [&] {
        const Lighting lighting(scene, drawn, scene.camera, size, 1, {.lights = lights, .sky = 1.0, .sun = {}});
        lighting.light(whole_picture, visible);
    }));
    std::printf("\"unit\": \"ms\"}\n");
    return 0;
}

// What a frame costs when nothing but the picture is wanted: building the lists, and tracing with lists built.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "app/backend.hpp"
#include "cost.hpp"
#include "cpu/cpu_renderer.hpp"
#include "random_scene.hpp"

namespace {

using namespace sphereview;

constexpr PictureSize size{1000, 1000};
constexpr Block whole_picture{0, 0, size.width, size.height};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4 || (std::string(argv[1]) != "volume" && std::string(argv[1]) != "half")) {
        std::fprintf(stderr, "usage: frames volume|half COUNT RUNS: one JSON line on standard output\n");
        return 2;
    }
    const std::size_t count = std::strtoul(argv[2], nullptr, 10);
    const int runs = std::max(1, std::atoi(argv[3]));
    const Scene scene = random_scene(std::string(argv[1]) == "volume" ? SceneSet::volume : SceneSet::half, count);
    const DrawnSpheres drawn = drawn_spheres(scene);
    std::vector<std::int32_t> visible(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    Timings timings;

    std::printf("{\"set\": \"%s\", \"count\": %zu, ", argv[1], count);
    print("drawn", median_cost(runs, [&] { drawn_spheres(scene); }));
    CandidateLists lists;
    print("cpu lists", median_cost(runs, [&] { lists = build_lists(drawn, scene.camera, size, cpu_tile_costs); }));
    const CpuRenderer cpu(drawn, lists, scene.camera, size);
    print("cpu frame", median_cost(runs, [&] { cpu.trace(whole_picture, visible); }));

    print("gpu lists", median_cost(runs, [&] { lists = build_lists(drawn, scene.camera, size, gpu_tile_costs); }));
    OpenBackend& backend = *new OpenBackend(open_backend(Backend::egl, std::nullopt, timings));
    GpuRenderer& gpu = *backend.gpu;
    print("upload", median_cost(runs, [&] { gpu.upload(drawn, lists, scene.camera, size, timings); }));
    const auto median_trace = median_cost(runs, [&] { gpu.trace(whole_picture, visible, timings); });
    print("gpu frame with read back", median_trace);
    const std::size_t drawn_bytes = drawn.center_radius.size() * sizeof(glm::vec4);
    const auto lists_bytes = static_cast<double>(lists.candidates.size() * sizeof(Candidate) + lists.begins.size() * 4);
    const double on_gpu = (lists_bytes + static_cast<double>(drawn_bytes)) / static_cast<double>(count);
    std::printf("\"bytes_per_sphere\": %.1f, \"gpu_bytes_per_sphere\": %.1f, ", on_gpu + sizeof(Sphere), on_gpu);
    std::printf("\"tiles\": [");
    for (std::size_t i = 0; i < lists.levels.size(); ++i) std::printf(i == 0 ? "%d" : ", %d", 1 << lists.levels[i].shift);
    std::printf("], \"candidates\": %zu, \"renderer\": \"%s\"}\n", lists.candidates.size(), backend.description.c_str());
    std::fflush(stdout);
    std::_Exit(0);
}

// The parts of a render one by one: reading, tracing on the CPU, encoding.
#include <benchmark/benchmark.h>

#include <vector>

#include "base/input_file.hpp"
#include "cpu/cpu_renderer.hpp"
#include "formats/scene_format.hpp"
#include "image/png.hpp"
#include "random_scene.hpp"
#include "shade/picture_shader.hpp"
#include "stb_default.hpp"

namespace {

using namespace sphereview;

constexpr PictureSize size{1000, 1000};
constexpr Block whole_picture{0, 0, size.width, size.height};
constexpr std::size_t million = 1'000'000;

std::vector<std::int32_t> trace(const DrawnSpheres& drawn, const Camera& camera) {
    std::vector<std::int32_t> visible(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    const CandidateLists lists = build_lists(drawn, camera, size, cpu_tile_costs);
    CpuRenderer(drawn, lists, camera, size).trace(whole_picture, visible);
    return visible;
}

Image picture_of(const Scene& scene) {
    Image picture = make_picture(size, scene.background);
    PictureShader(scene, scene.camera, size, Shading::flat, scene.background)
        .shade(whole_picture, trace(drawn_spheres(scene), scene.camera), picture);
    return picture;
}

const Image& input4_picture() {
    static const Image picture = [] {
        const InputFile file(SOURCE_DIR "/scenes/input4.txt");
        return picture_of(parse_scene(file.bytes(), file.name()));
    }();
    return picture;
}

const Image& busy_picture() {
    static const Image picture = picture_of(random_scene(SceneSet::half, 10'000));
    return picture;
}

void read(benchmark::State& state, SceneFormat format) {
    const std::string content = write_scene(random_scene(SceneSet::volume, million), format);
    for (auto _ : state) benchmark::DoNotOptimize(parse_scene(content, "scene").spheres.data());
    state.SetBytesProcessed(static_cast<std::int64_t>(content.size()) * state.iterations());
    state.counters["file_bytes"] = static_cast<double>(content.size());
}

void encode(benchmark::State& state, std::string (*encoder)(const Image&), const Image& (*picture)()) {
    const Image& image = picture();
    std::size_t bytes = 0;
    for (auto _ : state) {
        const std::string png = encoder(image);
        benchmark::DoNotOptimize(png.data());
        bytes = png.size();
    }
    state.counters["file_bytes"] = static_cast<double>(bytes);
}

void trace_on_cpu(benchmark::State& state) {
    const Scene scene = random_scene(SceneSet::volume, static_cast<std::size_t>(state.range(0)));
    const DrawnSpheres drawn = drawn_spheres(scene);
    for (auto _ : state) benchmark::DoNotOptimize(trace(drawn, scene.camera).data());
}

// Of a million pixels that show 10,000 spheres.
void shade(benchmark::State& state, Shading shading) {
    const Scene scene = random_scene(SceneSet::half, 10'000);
    const std::vector<std::int32_t> visible = trace(drawn_spheres(scene), scene.camera);
    Image picture = make_picture(size, scene.background);
    for (auto _ : state) {
        PictureShader(scene, scene.camera, size, shading, scene.background).shade(whole_picture, visible, picture);
        benchmark::DoNotOptimize(picture.bytes().data());
    }
}

// Real time: some of the work is done by several threads.
void timed(benchmark::internal::Benchmark* one) { one->Unit(benchmark::kMillisecond)->UseRealTime(); }

BENCHMARK_CAPTURE(read, text, SceneFormat::text)->Apply(timed);
BENCHMARK_CAPTURE(read, toml, SceneFormat::toml)->Apply(timed);
BENCHMARK_CAPTURE(encode, ours / input4, encode_png, input4_picture)->Apply(timed);
BENCHMARK_CAPTURE(encode, stb / input4, encode_png_stb, input4_picture)->Apply(timed);
BENCHMARK_CAPTURE(encode, ours / 10000_half, encode_png, busy_picture)->Apply(timed);
BENCHMARK_CAPTURE(encode, stb / 10000_half, encode_png_stb, busy_picture)->Apply(timed);
BENCHMARK_CAPTURE(shade, flat, Shading::flat)->Apply(timed);
BENCHMARK_CAPTURE(shade, headlight, Shading::headlight)->Apply(timed);
BENCHMARK_CAPTURE(shade, normal, Shading::normal)->Apply(timed);
BENCHMARK_CAPTURE(shade, depth, Shading::depth)->Apply(timed);
BENCHMARK_CAPTURE(shade, id, Shading::id)->Apply(timed);
BENCHMARK(trace_on_cpu)->Arg(4)->Arg(100)->Arg(1000)->Apply(timed);

}  // namespace

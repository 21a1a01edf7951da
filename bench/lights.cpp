// What light costs: all lights of a picture whose visible spheres are known, on all cores; and the first of them.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <span>
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

// Spheres that each cover the whole plane of any light: no tile is without them.
Scene huge_spheres(std::size_t count) {
    Scene scene = random_scene(SceneSet::volume, 1000);
    for (std::size_t i = 0; i < count; ++i) {
        const double turn = static_cast<double>(i) / static_cast<double>(count);
        scene.spheres.push_back({{900.0 * turn, 4000.0 - 500.0 * turn, 4000.0 + 700.0 * turn}, 3000.0 + turn, {}, false});
    }
    return scene;
}

// Spheres so far away that float knows nothing of them, each of which covers a tenth of the sky; some are above the picture's.
Scene far_spheres(std::size_t count) {
    Scene scene = random_scene(SceneSet::volume, 1000);
    for (std::size_t i = 0; i < count; ++i) {
        const double turn = static_cast<double>(i) / static_cast<double>(count);
        scene.spheres.push_back({{1e14 * (2.0 * turn - 1.0), 1e15, 1e14 * (1.0 - turn)}, 1e14, {}, false});
    }
    return scene;
}

// Before a sphere that is farther away than all others by far, and seen between them.
Scene before_background(std::size_t count) {
    Scene scene = random_scene(SceneSet::volume, count);
    scene.spheres.push_back({{0.0, 0.0, 1e10}, 9e9, {}, false});
    return scene;
}

// Whose squares leave the range of doubles.
Scene scaled_spheres(std::size_t count) {
    Scene scene = random_scene(SceneSet::volume, count);
    for (Sphere& sphere : scene.spheres) sphere = {1e160 * sphere.center, 1e160 * sphere.radius, {}, false};
    for (glm::dvec3* v : {&scene.camera.eye, &scene.camera.center, &scene.camera.right, &scene.camera.up}) *v *= 1e160;
    return scene;
}

// An ordinary scene before a sphere whose squares leave the range of doubles.
Scene before_a_giant(std::size_t count) {
    Scene scene = random_scene(SceneSet::volume, count);
    scene.spheres.push_back({{0.0, 0.0, 1e200}, 9e199, {}, false});
    return scene;
}

// Spheres nearly in one place, which hide and shadow each other.
Scene equal_spheres(std::size_t count) {
    Scene scene;
    for (std::size_t i = 0; i < count; ++i) {
        scene.spheres.push_back({{1e-9 * static_cast<double>(i % 97), 1e-9 * static_cast<double>(i % 89), 300.0}, 60.0, {}, false});
    }
    return scene;
}

std::optional<Scene> scene_named(const std::string& name, std::size_t count) {
    if (name == "huge") return huge_spheres(count);
    if (name == "equal") return equal_spheres(count);
    if (name == "far") return far_spheres(count);
    if (name == "background") return before_background(count);
    if (name == "scaled") return scaled_spheres(count);
    if (name == "giant") return before_a_giant(count);
    const auto set = scene_set_named(name);
    return set ? std::optional(random_scene(*set, count)) : std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
    const std::size_t count = argc == 5 ? std::strtoul(argv[2], nullptr, 10) : 0;
    const std::optional<Scene> made = argc == 5 ? scene_named(argv[1], count) : std::nullopt;
    if (!made) {
        std::fprintf(stderr,
                     "usage: lights volume|half|huge|equal|far|background|scaled|giant COUNT LIGHTS RUNS: one JSON line on "
                     "standard output\n");
        return 2;
    }
    const Scene& scene = *made;
    const int lights = std::clamp(std::atoi(argv[3]), fewest_lights, most_lights);
    const int runs = std::max(1, std::atoi(argv[4]));
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
    // From nothing but the numbers to the first preview, as the window's draft is made.
    print("first light", median_cost(runs, [&] {
              struct Seen {};
              const LightPreviews previews{.show = [](std::span<const LightVector>, double) { throw Seen(); }};
              try {
                  const DrawnSpheres again = drawn_spheres(scene);
                  const Lighting lighting(scene, again, scene.camera, size, 1, {.lights = lights, .sky = 1.0, .sun = {}});
                  lighting.light(whole_picture, visible, nullptr, &previews);
              } catch (const Seen&) {
              }
          }));
    std::printf("\"unit\": \"ms\"}\n");
    return 0;
}

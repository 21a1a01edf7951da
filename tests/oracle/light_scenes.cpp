#include "oracle/light_scenes.hpp"

#include <cmath>
#include <functional>
#include <utility>

#include "oracle/random.hpp"

namespace sphereview::oracle {

namespace {

// Directions that lattices have spheres, tangents and edges in.
glm::dvec3 whole_direction(Random& random) {
    glm::dvec3 v{0.0};
    while (v == glm::dvec3(0.0)) {
        v = {random.whole(-2, 2), random.whole(-2, 2), random.whole(-2, 2)};
    }
    return v;
}

}  // namespace

Light sky_and_sun(const glm::dvec3& direction) { return {.lights = 16, .sky = 1.0, .sun = Sun{direction, 1.0}}; }

LitTrial with_light(Trial trial, std::uint64_t seed) {
    Random random(seed);
    const glm::dvec3 direction = random.chance(0.6) ? whole_direction(random) : random.in_cube(1.0);
    return {std::move(trial), sky_and_sun(direction)};
}

Scene lit_middle() {
    Scene scene;
    scene.spheres.push_back({{0.0, 0.0, 200.0}, 20.0, {255, 0, 0}});
    return scene;
}

std::vector<LitTrial> light_edges() {
    std::vector<LitTrial> all;
    const auto add = [&](const std::string& name, Scene scene, const glm::dvec3& direction) {
        for (const int side : {9, 21}) {
            all.push_back({{name, scene, {side, side}}, sky_and_sun(direction)});
        }
    };
    Scene scene = lit_middle();
    add("alone", scene, slanting);
    add("light at a right angle to the normal", scene, {0.0, 1.0, 0.0});
    add("light behind", scene, {0.0, 0.0, 1.0});
    scene.spheres.push_back({{40.0, 5.0, 140.0}, 5.0, {0, 255, 0}});
    add("line to the light touches a sphere", scene, slanting);
    scene.spheres[1].center = {-40.0, 5.0, 220.0};
    add("line away from the light touches a sphere", scene, slanting);
    scene.spheres[1] = {{40.0, 0.0, 140.0}, 5.0, {0, 255, 0}};
    add("sphere in the way", scene, slanting);
    scene.spheres[1].hidden = true;
    add("hidden sphere in the way", scene, slanting);
    scene.spheres[1] = {{0.0, 0.0, 0.0}, 500.0, {0, 255, 0}};
    add("all in a sphere that holds the eye", scene, slanting);
    scene.spheres[1] = {{0.0, 0.0, 40.0}, 40.0, {0, 255, 0}};
    add("the eye on a sphere", scene, slanting);
    scene.spheres[1] = {{0.0, 40.0, 200.0}, 20.0, {0, 255, 0}};
    add("touching spheres", scene, {0.0, 1.0, 0.0});
    add("touching spheres, light across", scene, {0.0, 0.0, -1.0});
    scene.spheres[1] = scene.spheres[0];
    add("equal spheres", scene, slanting);
    scene.spheres[1].radius = std::nextafter(20.0, 0.0);
    add("nearly equal spheres", scene, slanting);
    scene.spheres[1] = {{0.0, 5.0, 200.0}, 15.0, {0, 255, 0}};
    add("a sphere within, touching", scene, {0.0, 1.0, 0.0});
    scene.spheres[1] = {{10.0, 0.0, 190.0}, 15.0, {0, 255, 0}};
    add("spheres that cross", scene, {1.0, 0.0, 0.0});
    scene = Scene{};
    scene.spheres.push_back({{0.0, 0.0, 0.0}, 300.0, {255, 0, 0}});
    scene.spheres.push_back({{30.0, 30.0, 200.0}, 40.0, {0, 255, 0}});
    add("in a room", scene, {0.0, 0.0, -1.0});
    for (const double factor : {1e-150, 1e-40, 1e30, 1e120}) {
        scene = lit_middle();
        scene.spheres.push_back({{40.0, 5.0, 140.0}, 5.0, {0, 255, 0}});
        scene.spheres.push_back({{10.0, -20.0, 160.0}, 10.0, {0, 0, 255}});
        for (Sphere& sphere : scene.spheres) sphere = {sphere.center * factor, sphere.radius * factor, sphere.color};
        for (glm::dvec3* v : {&scene.camera.center, &scene.camera.right, &scene.camera.up}) *v *= factor;
        add("scaled by " + std::to_string(factor), scene, slanting);
    }
    scene = lit_middle();
    scene.spheres.push_back({{0.0, -1e9 - 20.0, 200.0}, 1e9, {0, 255, 0}});
    scene.spheres.push_back({{1e160, 0.0, -1e160}, 1e158, {0, 255, 0}});
    scene.spheres.push_back({{3.0, 3.0, 170.0}, 1e-200, {0, 255, 0}});
    add("sizes far apart", scene, slanting);
    return all;
}

std::vector<Surroundings> surroundings(int spheres, int others) {
    Random random(seed());
    Scene ordinary;
    for (int i = 0; i < spheres; ++i) {
        const glm::dvec3 center = random.in_cube(60.0) + glm::dvec3(0.0, 0.0, 220.0);
        ordinary.spheres.push_back({center, 4.0 + i % 9, {255, 0, 0}, false});
    }
    std::vector<Surroundings> all;
    all.push_back({"nothing around", ordinary});
    for (const double distance : {1e7, 1e15, 1e190}) {
        Surroundings far{"spheres at " + std::to_string(distance), ordinary};
        for (int i = 0; i < others; ++i) {
            const glm::dvec3 center = 0.1 * distance * random.in_cube(1.0) + glm::dvec3(0.0, distance, 0.0);
            far.scene.spheres.push_back({center, 0.1 * distance, {0, 255, 0}, false});
        }
        all.push_back(far);
    }
    for (const double distance : {1e6, 1e10, 1e20, 1e200}) {
        Surroundings background{"before a sphere at " + std::to_string(distance), ordinary};
        background.scene.spheres.push_back({{0.0, 0.0, distance}, 0.9 * distance, {0, 0, 255}, false});
        all.push_back(background);
    }
    for (const double factor : {1e-140, 1e160}) {
        Surroundings scaled{"scaled by " + std::to_string(factor), ordinary};
        for (Sphere& sphere : scaled.scene.spheres) sphere = {sphere.center * factor, sphere.radius * factor, sphere.color};
        Camera& camera = scaled.scene.camera;
        for (glm::dvec3* v : {&camera.eye, &camera.center, &camera.right, &camera.up}) *v *= factor;
        all.push_back(scaled);
    }
    return all;
}

std::vector<LitTrial> light_crowds() {
    std::vector<LitTrial> all;
    Random random(seed());
    const auto add = [&](const std::string& name, const Scene& scene, PictureSize size, const glm::dvec3& direction) {
        all.push_back({{name, scene, size}, sky_and_sun(direction)});
    };
    for (const bool shadowed : {false, true}) {
        Scene scene = lit_middle();
        for (int i = 0; i < 12; ++i) {
            scene.spheres.push_back({random.in_cube(60.0) + glm::dvec3(0.0, 0.0, 220.0), 3.0 + i, {0, 255, 0}, false});
        }
        for (int i = 0; i < 1000; ++i) {
            const double turn = i / 1000.0;
            // Above them all, or behind, where no light comes through.
            const glm::dvec3 center{900.0 * turn, 4000.0 - 500.0 * turn, (shadowed ? 2000.0 : 4000.0) + 700.0 * turn};
            scene.spheres.push_back({center, 3000.0 + turn, {0, 0, 255}, false});
        }
        add(shadowed ? "a thousand huge spheres around" : "a thousand huge spheres above", scene, {7, 5}, {0.0, 1.0, 0.1});
    }
    for (const double apart : {0.0, 1e-9, 1e-13}) {
        Scene scene = lit_middle();
        for (int i = 0; i < 400; ++i) {
            const glm::dvec3 center{40.0 + apart * (i % 19), apart * (i % 17), 140.0 + apart * (i % 13)};
            scene.spheres.push_back({center, 25.0 + apart * (i % 11), {0, 255, 0}, false});
        }
        add("spheres " + std::to_string(apart) + " apart", scene, {13, 9}, slanting);
    }
    for (const Surroundings& around : surroundings(20, 30)) {
        add(around.name, around.scene, {13, 9}, slanting);
        all.push_back({orthographic(all.back().trial), all.back().light});
    }
    return all;
}

Trials hard_to_light(int spheres, PictureSize size) {
    Trials trials = stress_trials(spheres, size);
    const auto add = [&](const std::string& name, const std::function<Sphere(int)>& sphere) {
        Trial trial{"hard to light: " + name, {}, size};
        for (int i = 0; i < spheres; ++i) trial.scene.spheres.push_back(sphere(i));
        trials.push_back(trial);
    };
    Random random(seed());
    const auto small = [&] { return Sphere{random.in_cube(90.0) + glm::dvec3(0.0, 0.0, 200.0), 6.0, {}, false}; };
    add("two planes", [](int i) {
        return i % 2 == 0 ? Sphere{{0.0, 0.0, 1e15 + i}, 1e15 + i - 100, {}, false}
                          : Sphere{{1e15 + i, 0.0, 100.0}, 1e15 + i - 10, {}, false};
    });
    add("a plane behind small ones", [&](int i) {
        return i % 2 == 0 ? Sphere{{0.0, 0.0, 1e15 + i}, 1e15 + i - 300, {}, false} : small();
    });
    // Seen from so far that a sphere is not much larger than what double is off.
    add("tiny ones", [](int i) {
        return Sphere{{1e-9 * (i % 40 - 20), 1e-9 * (i / 40 % 40 - 12), 100.0 + 1e-10 * (i % 7)}, 4e-10, {}, false};
    });
    Camera& camera = trials.back().scene.camera;
    camera.right *= 4e-10;
    camera.up *= 4e-10;
    return trials;
}

}  // namespace sphereview::oracle

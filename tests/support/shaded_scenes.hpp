// Scenes whose surfaces are shaded: by the export's formulae, and by the window's shaders.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview {

// Integers and quarters, so that every platform makes the same.
inline Scene shaded_scene(int count, unsigned seed) {
    std::mt19937 random(seed);
    const auto number = [&](int low, int high) { return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1)); };
    Scene scene;
    scene.background.color = {1, 2, 3};
    for (int i = 0; i < count; ++i) {
        Sphere sphere;
        sphere.center = {0.25 * number(-400, 400), 0.25 * number(-400, 400), number(80, 500)};
        sphere.radius = 0.25 * number(20, 160);
        sphere.color = {static_cast<std::uint8_t>(number(0, 255)), static_cast<std::uint8_t>(number(0, 255)),
                        static_cast<std::uint8_t>(number(0, 255))};
        scene.spheres.push_back(sphere);
    }
    return scene;
}

// A scene seen by an eye off the axis, one inside a sphere, and one of tiny, huge and very far spheres.
inline std::vector<Scene> shaded_scenes() {
    std::vector<Scene> all = {shaded_scene(40, 1), shaded_scene(40, 2), shaded_scene(20, 3), shaded_scene(20, 4)};
    all[1].camera = {{30.0, 40.0, -20.0}, {0.0, 10.0, 80.0}, {0.0, 0.0, 40.0}, {40.0, 0.0, 0.0}};
    all[2].spheres.push_back({{0, 5, 10}, 700, {200, 100, 50}, false});
    all[3].spheres.push_back({{0, -1e6, 0}, 999'990, {90, 200, 50}, false});
    all[3].spheres.push_back({{0, 1, 60}, 0.5, {250, 200, 50}, false});
    return all;
}

}  // namespace sphereview

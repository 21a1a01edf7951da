// Changes of a scene. Each can be applied, and gives what takes it back.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview {

// A sphere with what a scene keeps beside it.
struct NamedSphere {
    Sphere sphere;
    std::string name;  // "" for none

    bool operator==(const NamedSphere&) const = default;
};

// Spheres get other values. The numbers ascend; spheres[i] is for numbers[i].
struct ChangeSpheres {
    std::vector<std::uint32_t> numbers;
    std::vector<Sphere> spheres;
};

// Spheres come in. The numbers, which ascend, are those that they have afterwards.
struct InsertSpheres {
    std::vector<std::uint32_t> numbers;
    std::vector<NamedSphere> spheres;
};

// Spheres go out. The numbers ascend.
struct RemoveSpheres {
    std::vector<std::uint32_t> numbers;
};

// One sphere gets another place in the order; those between move up or down by one. Names go along.
struct ReorderSphere {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
};

struct RenameSphere {
    std::uint32_t number = 0;
    std::string name;  // "" takes the name away
};

struct ChangeCamera {
    Camera camera;
};

struct ChangeBackground {
    Background background;
};

// Everything becomes another scene, as when a file is read anew.
struct ReplaceScene {
    Scene scene;
};

using Edit = std::variant<ChangeSpheres, InsertSpheres, RemoveSpheres, ReorderSphere, RenameSphere, ChangeCamera, ChangeBackground,
                          ReplaceScene>;

// Applies an edit, whose numbers must fit the scene, and returns its inverse: applied next, it gives the same scene back,
// and its own inverse is the edit. Moves what it can; copies nothing that the edit does not touch.
Edit apply(Edit edit, Scene& scene);

}  // namespace sphereview

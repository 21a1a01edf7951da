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
    std::vector<Property> properties{};  // their values, for those properties of the scene that have one of these names
};

// How many words a property of the scene had.
struct WordCount {
    std::string property;
    std::size_t words = 0;
};

// Spheres go out. The numbers ascend.
struct RemoveSpheres {
    std::vector<std::uint32_t> numbers;
    std::vector<WordCount> words{};  // of an insertion that is taken back: words behind these came with it
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
    bool moves_view =
        false;  // whoever looks from the scene's camera looks from the new one afterwards, as when its numbers are edited
};

struct ChangeBackground {
    Background background;
};

struct ChangeLight {
    Light light;
};

// All of them: they are few.
struct ChangeViews {
    std::vector<SavedView> views;
};

// Everything becomes another scene, as when a file is read anew.
struct ReplaceScene {
    Scene scene;
};

using Edit = std::variant<ChangeSpheres, InsertSpheres, RemoveSpheres, ReorderSphere, RenameSphere, ChangeCamera, ChangeBackground,
                          ChangeLight, ChangeViews, ReplaceScene>;

// Applies an edit, whose numbers must fit the scene, and returns its inverse: applied next, it gives the same scene back,
// and its own inverse is the edit. Moves what it can; copies nothing that the edit does not touch.
Edit apply(Edit edit, Scene& scene);

// Whether the scene would be the same, bit for bit, after the edit. Places count even where equal spheres change them.
bool changes_nothing(const Edit& edit, const Scene& scene);

// The spheres that an edit is about, by the numbers that they have afterwards, ascending: those that are changed, put in, moved
// or renamed. None for what goes out, and for what concerns the whole scene.
std::vector<std::uint32_t> numbers_concerned(const Edit& edit);

// The numbers that these spheres, ascending, have after the edit, ascending; without those that it takes out. For keeping a
// selection. Another scene has, as far as anyone can tell, the same spheres under the same numbers.
std::vector<std::uint32_t> numbers_after(const Edit& edit, std::vector<std::uint32_t> numbers);

}  // namespace sphereview

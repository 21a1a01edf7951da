// Changes of a scene, each of which can be applied and inverted.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview {

// A sphere and its name.
struct NamedSphere {
    Sphere sphere;
    std::string name;  // "" for none

    bool operator==(const NamedSphere&) const = default;
};

// Gives spheres other values. The numbers ascend; spheres[i] is for numbers[i].
struct ChangeSpheres {
    std::vector<std::uint32_t> numbers;
    std::vector<Sphere> spheres;
};

// Inserts spheres. The numbers ascend and count after the insertion.
struct InsertSpheres {
    std::vector<std::uint32_t> numbers;
    std::vector<NamedSphere> spheres;
    std::vector<Property> properties{};  // their values, for the scene's properties of the same names
};

// The number of words of a property.
struct WordCount {
    std::string property;
    std::size_t words = 0;
};

// Removes spheres. The numbers ascend.
struct RemoveSpheres {
    std::vector<std::uint32_t> numbers;
    std::vector<WordCount> words{};  // to take an insertion back: drops the words behind these
};

// Gives a sphere another number; those between move up or down by one. Names go along.
struct ReorderSphere {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
};

struct RenameSphere {
    std::uint32_t number = 0;
    std::string name;  // "" removes the name
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

// Replaces all saved views: they are few.
struct ChangeViews {
    std::vector<SavedView> views;
};

// Replaces the whole scene, as when a file is read again.
struct ReplaceScene {
    Scene scene;
};

using Edit = std::variant<ChangeSpheres, InsertSpheres, RemoveSpheres, ReorderSphere, RenameSphere, ChangeCamera, ChangeBackground,
                          ChangeLight, ChangeViews, ReplaceScene>;

// Applies an edit, whose numbers must fit the scene, and returns its inverse. Moves if possible, and copies nothing that the edit
// does not touch.
Edit apply(Edit edit, Scene& scene);

// Whether the edit would leave the scene the same, bit for bit. Exchanging equal spheres counts as a change.
bool changes_nothing(const Edit& edit, const Scene& scene);

// The spheres that an edit changes, inserts, moves or renames, by their numbers afterwards, ascending. None for removals and for
// edits of the whole scene.
std::vector<std::uint32_t> numbers_concerned(const Edit& edit);

// The numbers of these spheres after the edit, for keeping a selection; both ascend. Removed spheres are left out; ReplaceScene
// keeps all numbers.
std::vector<std::uint32_t> numbers_after(const Edit& edit, std::vector<std::uint32_t> numbers);

}  // namespace sphereview

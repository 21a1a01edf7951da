// A scene, and its bounds.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/camera.hpp"
#include "scene/light.hpp"
#include "scene/property.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

// The colour of pixels that show no sphere. A transparent background makes the picture RGBA.
struct Background {
    Color color{0, 0, 0};
    bool transparent = false;

    bool operator==(const Background&) const = default;
};

// The syntax of a background for messages and help.
inline constexpr std::string_view background_syntax = "black, white, transparent or #rrggbb";

// Reads a text of background_syntax. Returns false, and leaves `background` alone, for another text.
bool parse_background(std::string_view text, Background& background);

// The shortest spelling that parse_background reads back as the same.
std::string to_string(const Background& background);

// The most spheres a scene may have: their numbers, and the marks for doubtful pixels, share a signed 32-bit integer.
inline constexpr std::int64_t most_spheres = 2'000'000'000;

// A camera that the scene keeps beside its own, by a unique name that view_name_fault() allows.
struct SavedView {
    std::string name;
    Camera camera;

    bool operator==(const SavedView&) const = default;
};

// The sides that every scene can be seen from.
inline constexpr std::array<std::string_view, 7> view_sides = {"front", "back", "left", "right", "top", "bottom", "iso"};

// Why no saved view can have this name: it has no letter, or means a side or `AZIMUTH,ELEVATION`. "the name of a side"; "" if one
// can.
std::string view_name_fault(std::string_view name);

// Spheres are numbered from 0 in file order; of two equal hits the lower number is seen.
struct Scene {
    std::vector<Sphere> spheres;
    std::map<std::uint32_t, std::string> names;  // only of the spheres that have one
    Background background;
    Camera camera;
    Light light{};
    std::vector<SavedView> views{};
    std::vector<Property> properties{};  // each with a value for every sphere; only those asked for

    bool operator==(const Scene&) const = default;
};

// The bounds of the shown spheres. Of an empty scene: what the default screen shows at z = 200.
struct SceneBounds {
    glm::dvec3 low{-100.0, -100.0, 100.0};
    glm::dvec3 high{100.0, 100.0, 300.0};
    double largest_radius = 20.0;
    std::size_t hidden = 0;  // number of hidden spheres

    glm::dvec3 middle() const { return 0.5 * low + 0.5 * high; }
    // The longest side, but not less than the largest sphere: more than 0, and finite.
    double extent() const;
};

SceneBounds bounds_of(const Scene& scene);

// Whether values are the same bit for bit. A file tells -0 from 0; == does not.
inline bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

inline bool same_bits(const glm::dvec3& a, const glm::dvec3& b) {
    return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

// Whether everything is the same that decides which pixels a sphere may take.
inline bool same_geometry(const Sphere& a, const Sphere& b) {
    return same_bits(a.center, b.center) && same_bits(a.radius, b.radius) && a.hidden == b.hidden;
}

inline bool same_bits(const Sphere& a, const Sphere& b) { return same_geometry(a, b) && a.color == b.color; }

inline bool same_bits(const Camera& a, const Camera& b) {
    return same_bits(a.eye, b.eye) && same_bits(a.center, b.center) && same_bits(a.right, b.right) && same_bits(a.up, b.up) &&
           a.projection == b.projection;
}

inline bool same_bits(const SavedView& a, const SavedView& b) { return a.name == b.name && same_bits(a.camera, b.camera); }

inline bool same_bits(const Light& a, const Light& b) {
    return a == b && same_bits(a.sky.value_or(1.0), b.sky.value_or(1.0)) && same_bits(a.key, b.key) &&
           (!a.sun || same_bits(a.sun->direction, b.sun->direction));
}

}  // namespace sphereview

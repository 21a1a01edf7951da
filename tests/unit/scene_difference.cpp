#include "unit/scene_difference.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>

namespace sphereview {

namespace {

std::string hexadecimal(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%a", value);
    return text.data();
}

std::string difference(const std::string& what, double actual, double expected) {
    if (std::bit_cast<std::uint64_t>(actual) == std::bit_cast<std::uint64_t>(expected)) return "";
    return what + ": " + hexadecimal(actual) + " instead of " + hexadecimal(expected);
}

std::string difference(const std::string& what, const glm::dvec3& actual, const glm::dvec3& expected) {
    std::string text;
    for (int i = 0; i < 3 && text.empty(); ++i) {
        text = difference(what + "[" + std::to_string(i) + "]", actual[i], expected[i]);
    }
    return text;
}

std::string difference(const std::string& what, const Sphere& actual, const Sphere& expected) {
    if (actual.color != expected.color) return what + ": another colour";
    if (actual.hidden != expected.hidden) return what + ": hidden or not";
    const std::string text = difference(what + ".center", actual.center, expected.center);
    return text.empty() ? difference(what + ".radius", actual.radius, expected.radius) : text;
}

std::string difference(const std::string& what, const Camera& actual, const Camera& expected) {
    if (actual.projection != expected.projection) return what + ": another projection";
    for (const auto& [name, member] : {std::pair{"eye", &Camera::eye}, std::pair{"center", &Camera::center},
                                       std::pair{"right", &Camera::right}, std::pair{"up", &Camera::up}}) {
        const std::string text = difference(what + "." + name, actual.*member, expected.*member);
        if (!text.empty()) return text;
    }
    return "";
}

}  // namespace

std::string difference(const Scene& actual, const Scene& expected) {
    if (actual.background != expected.background) return "another background";
    if (!same_bits(actual.light, expected.light)) return "another light";
    if (const std::string text = difference("camera", actual.camera, expected.camera); !text.empty()) return text;
    if (actual.views.size() != expected.views.size()) return "other views";
    for (std::size_t i = 0; i < actual.views.size(); ++i) {
        if (actual.views[i].name != expected.views[i].name) return "another name of view " + std::to_string(i);
        const std::string text = difference("view " + std::to_string(i), actual.views[i].camera, expected.views[i].camera);
        if (!text.empty()) return text;
    }
    if (actual.spheres.size() != expected.spheres.size()) {
        return std::to_string(actual.spheres.size()) + " spheres instead of " + std::to_string(expected.spheres.size());
    }
    for (std::size_t i = 0; i < actual.spheres.size(); ++i) {
        const std::string text = difference("sphere " + std::to_string(i), actual.spheres[i], expected.spheres[i]);
        if (!text.empty()) return text;
    }
    if (actual.properties != expected.properties) return "other properties";
    return actual.names == expected.names ? "" : "other names";
}

Scene without_extras(const Scene& scene) {
    Scene plain;
    for (const Sphere& sphere : scene.spheres) {
        if (!sphere.hidden) plain.spheres.push_back(sphere);
    }
    return plain;
}

}  // namespace sphereview

#include "formats/text_format.hpp"

#include <algorithm>

namespace sphereview {

std::vector<Sphere> parse_text_spheres(const TextSource& source) {
    SphereTextReader reader(source.name, source.origin, source.text.size());
    reader.read(source.text, true);
    return reader.take_spheres();
}

std::string write_text_spheres(const std::vector<Sphere>& spheres) {
    const auto drawn = std::count_if(spheres.begin(), spheres.end(), [](const Sphere& s) { return !s.hidden; });
    std::string text = std::to_string(drawn) + "\n";
    for (const Sphere& sphere : spheres) {
        if (sphere.hidden) continue;
        text += std::to_string(sphere.color.r) + ' ' + std::to_string(sphere.color.g) + ' ' + std::to_string(sphere.color.b) + '\n';
        text += shortest(sphere.center.x);
        text += ' ';
        text += shortest(sphere.center.y);
        text += ' ';
        text += shortest(sphere.center.z);
        text += '\n';
        text += shortest(sphere.radius);
        text += '\n';
    }
    return text;
}

}  // namespace sphereview

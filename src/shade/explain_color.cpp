#include "shade/explain_color.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "scene/vectors.hpp"
#include "shade/brightness.hpp"
#include "shade/picture_shader.hpp"

namespace sphereview {

namespace {

std::string text_of(double value, int digits) { return decimal(value + 0.0, std::chars_format::general, digits); }

}  // namespace

glm::dvec3 in_units(const LightVector& sum) {
    return glm::dvec3(static_cast<double>(sum.x), static_cast<double>(sum.y), static_cast<double>(sum.z)) / light_one;
}

ColorExplanation explain_color(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel, const ExplainedHit& hit,
                               const glm::dvec3& direction, const LightVector& sum) {
    ColorExplanation found;
    found.sum = sum;
    found.turned = dot(hit.normal, direction) > 0.0;
    found.normal = found.turned ? -hit.normal : hit.normal;
    found.brightness = std::max(dot(found.normal, in_units(sum)), 0.0);
    found.part = std::min(shown_part(found.brightness), 1.0);
    found.own = scene.spheres[static_cast<std::size_t>(hit.number)].color;
    const PictureShader shader(scene, camera, size, Shading::studio, scene.background);
    found.shown = shader.color(pixel, hit.number, sum);
    return found;
}

std::vector<std::string> in_words(const ColorExplanation& explanation, int digits) {
    if (explanation.sum == LightVector{}) return {"no light shines there: black"};
    std::vector<std::string> lines;
    if (explanation.turned) lines.emplace_back("n turned to the eye, which sees the sphere's inside: n = (C - P) / r");
    lines.push_back("E = n.B = " + text_of(explanation.brightness, digits) + ", what the lights make of the surface");
    const double part = shown_part(explanation.brightness);
    lines.push_back("s = 1.8 E / (0.8 + E) = " + text_of(part, digits) + (part > 1.0 ? ", which counts as 1" : "") +
                    ", the part of its colour that shows");
    lines.push_back("colour = s times " + in_words(explanation.own) + " = " + in_words(explanation.shown));
    return lines;
}

}  // namespace sphereview

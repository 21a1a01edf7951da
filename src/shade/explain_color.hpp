// Explains the colour of a lit pixel, in numbers that can be checked by hand.
#pragma once

#include <string>
#include <vector>

#include "exact/explain.hpp"
#include "light/light_set.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// In the shading `studio`, at the pixel's middle. docs/shading.md has the formula.
struct ColorExplanation {
    LightVector sum;          // B
    glm::dvec3 normal{0.0};   // n, of length 1, turned towards the ray's origin
    bool turned = false;      // n points to the sphere's centre
    double brightness = 0.0;  // E = n.B / 2^28, at least 0
    double part = 0.0;        // of the own colour that shows, at most 1
    Color own;
    Color shown;  // in exports
};

// `hit`: the one that the pixel shows, on the ray with this direction. `sum`: of the lights that shine there.
ColorExplanation explain_color(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel, const ExplainedHit& hit,
                               const glm::dvec3& direction, const LightVector& sum);

// B in units in which a light of strength 1 has length 1.
glm::dvec3 in_units(const LightVector& sum);

// The way from B to the colour in lines, with so many significant digits.
std::vector<std::string> in_words(const ColorExplanation& explanation, int digits);

}  // namespace sphereview

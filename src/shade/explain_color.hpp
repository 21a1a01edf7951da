// How the colour of a lit pixel comes about, in numbers that can be checked by hand.
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
    glm::dvec3 normal{0.0};   // n, of length 1, turned to where the ray comes from
    bool turned = false;      // whether that is not the normal of the hit, away from the sphere's centre
    double brightness = 0.0;  // E = n.B / 2^28, at least 0
    double part = 0.0;        // of its own colour that shows, at most 1
    Color own;
    Color shown;  // as an export has it
};

// `hit`: of what the pixel shows, along the ray with that direction; `sum`: of the lights that shine there.
ColorExplanation explain_color(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel, const ExplainedHit& hit,
                               const glm::dvec3& direction, const LightVector& sum);

// B as three numbers, of which a light of strength 1 is 1 long.
glm::dvec3 in_units(const LightVector& sum);

// From B to the colour, a line each, with so many significant digits.
std::vector<std::string> in_words(const ColorExplanation& explanation, int digits);

}  // namespace sphereview

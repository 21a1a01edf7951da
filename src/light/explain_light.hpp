// Explains which lights shine on what a pixel shows, and which spheres block the others.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exact/drawn.hpp"
#include "exact/exact_light.hpp"
#include "light/light_set.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// A pixel of a camera's picture, and the sphere that the pixel shows.
struct LitPixel {
    const Scene& scene;
    const DrawnSpheres& drawn;  // by this camera
    const Camera& camera;
    PictureSize size;
    Pixel pixel;
    std::int32_t visible;
};

// The lights of a picture with one point a pixel, numbered for people: 0 is the sun, and the sky's begin at 1, in the order of
// their sum.
class NumberedLights {
public:
    NumberedLights(const Light& light, std::size_t spheres, const Camera& camera);

    std::span<const DirectedLight> sky() const { return std::span(lights_).subspan(first_ == 0 ? 1 : 0); }
    bool has(int number) const { return number >= first_ && static_cast<std::size_t>(number - first_) < lights_.size(); }
    // The light must exist.
    const DirectedLight& at(int number) const { return lights_[static_cast<std::size_t>(number - first_)]; }
    // The sun, or without a sun the sky's strongest light, nearest to the key light. Nothing where there is no light.
    std::optional<int> main() const;
    // "0 (the sun) or 1 to 256".
    std::string numbers_in_words() const;

private:
    std::vector<DirectedLight> lights_;
    int first_;  // the number of the first: 0 with a sun, else 1
    glm::dvec3 key_;
};

struct LightExplanation {
    int facing = 0;                       // the sign of n.L
    std::optional<std::int32_t> blocker;  // the first sphere of the scene that blocks the light, if n.L > 0
    BlockingSigns signs;                  // the blocker's

    bool shines() const { return facing > 0 && !blocker; }
};

LightExplanation explain_light(const LitPixel& pixel, const glm::dvec3& direction);

// "shines", or why the light does not.
std::string in_words(const LightExplanation& explanation);

// One of the numbered lights.
struct ExplainedLight {
    int number = 0;
    DirectedLight light;
    LightExplanation explanation;

    bool is_sun() const { return number == 0; }
};
ExplainedLight explain_light(const LitPixel& pixel, const NumberedLights& lights, int number);

// How many of many lights shine, and what blocks the others.
struct SkyExplanation {
    struct Blocker {
        std::int32_t number = 0;
        int lights = 0;  // that it blocks, perhaps with other spheres
    };

    int lights = 0;
    int shining = 0;
    int behind = 0;                 // n.L <= 0
    int blocked = 0;                // the others
    LightVector sum;                // of the shining lights
    std::vector<Blocker> blockers;  // the spheres that block most lights, the worst first
};

SkyExplanation explain_sky(const LitPixel& pixel, std::span<const DirectedLight> lights);

// "37 of 64 lights shine; ..."
std::string in_words(const SkyExplanation& explanation);

// All explanations of the light on a pixel.
struct PixelLights {
    std::optional<ExplainedLight> main;  // NumberedLights::main()
    std::optional<SkyExplanation> sky;   // unless there is none, or it would take too long
    std::optional<LightVector> sum;      // of all shining lights, the pixel's B, unless it would take too long
};

// `most_lines`: bound on the tests of a line to a light against a sphere, some 80 nanoseconds each.
PixelLights explain_lights(const LitPixel& pixel, const NumberedLights& lights,
                           std::size_t most_lines = std::numeric_limits<std::size_t>::max());

}  // namespace sphereview

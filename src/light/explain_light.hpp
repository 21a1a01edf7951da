// Whether lights shine on what a pixel shows, and which spheres keep them away, and why.
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

// A pixel inside the picture that a camera sees, and the sphere that it shows.
struct LitPixel {
    const Scene& scene;
    const DrawnSpheres& drawn;  // as the camera sees them
    const Camera& camera;
    PictureSize size;
    Pixel pixel;
    std::int32_t visible;
};

// The lights of a picture with one point a pixel as people number them: 0 is the sun, and the sky's begin at 1, in the order in
// which they are added.
class NumberedLights {
public:
    NumberedLights(const Light& light, std::size_t spheres, const Camera& camera);

    std::span<const DirectedLight> sky() const { return std::span(lights_).subspan(first_ == 0 ? 1 : 0); }
    bool has(int number) const { return number >= first_ && static_cast<std::size_t>(number - first_) < lights_.size(); }
    // Of a light that there is.
    const DirectedLight& at(int number) const { return lights_[static_cast<std::size_t>(number - first_)]; }
    // The sun; without one the sky's light that is nearest to the key light, which is its strongest. None where there is no light.
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

// What becomes of many lights.
struct SkyExplanation {
    struct Blocker {
        std::int32_t number = 0;
        int lights = 0;  // that it keeps away, perhaps with others
    };

    int lights = 0;
    int shining = 0;
    int behind = 0;                 // n.L <= 0
    int blocked = 0;                // the others
    LightVector sum;                // of those that shine
    std::vector<Blocker> blockers;  // those that keep most lights away, the worst first
};

SkyExplanation explain_sky(const LitPixel& pixel, std::span<const DirectedLight> lights);

// "37 of 64 lights shine; ..."
std::string in_words(const SkyExplanation& explanation);

// What there is to say of the light on a pixel.
struct PixelLights {
    std::optional<ExplainedLight> main;  // NumberedLights::main()
    std::optional<SkyExplanation> sky;   // unless there is none, or it would take too long
    std::optional<LightVector> sum;      // of all lights that shine, the pixel's B, unless that would take too long
};

// `most_lines`: as many lines from the point to a light may be tried against a sphere for the sky, some 80 nanoseconds each.
PixelLights explain_lights(const LitPixel& pixel, const NumberedLights& lights,
                           std::size_t most_lines = std::numeric_limits<std::size_t>::max());

}  // namespace sphereview

// Explains one pixel: all numbers that decide what it shows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <string>
#include <vector>

#include "exact/candidates.hpp"
#include "exact/drawn.hpp"
#include "exact/filter.hpp"
#include "exact/resolve.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// The root of the quadratic that is the hit, and the reason.
enum class CountingRoot {
    t1,         // both are positive: the smaller
    t2_inside,  // the eye is inside: t1 < 0 < t2
    t2_surface  // the eye is on the surface: t1 = 0 does not count
};

// A sphere and the line of the pixel's ray. All numbers are the exact ones rounded once to the nearest double (infinite when
// a double cannot hold them), so they can be checked against a t^2 + b t + c = 0 with
// a = D.D, b = 2 D.(O - C), c = (O - C).(O - C) - r^2, discriminant = b^2 - 4 a c.
struct SphereOnLine {
    std::int32_t number = 0;  // in the scene
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;
    double discriminant = 0.0;
    int discriminant_sign = 0;  // exact: -1 missed, 0 tangent, 1 two roots
    double t1 = 0.0;            // the roots
    double t2 = 0.0;
};

// A sphere that the ray hits.
struct ExplainedHit : SphereOnLine {
    EyeSide eye = EyeSide::outside;  // where the ray begins
    Projection projection = Projection::perspective;
    CountingRoot counts = CountingRoot::t1;
    double t = 0.0;                // t1 or t2
    glm::dvec3 point{0.0};         // O + t D
    glm::dvec3 normal{0.0};        // (point - C) / r, away from the centre
    bool as_near_as_last = false;  // exactly the same t as the hit before
};

struct PixelExplanation {
    Projection projection = Projection::perspective;
    glm::dvec3 origin{0.0};          // O, rounded once
    glm::dvec3 direction{0.0};       // D, likewise
    std::vector<ExplainedHit> hits;  // nearest first; of equal ones the first in the file first
    std::int64_t farther = 0;        // further hits, if not all were asked for
    std::int64_t missed = 0;         // discriminant below 0
    std::int64_t behind = 0;         // no positive root
    std::int64_t hidden = 0;
    std::int64_t elsewhere = 0;                     // missed or behind, and not tried: in no list of the pixel
    DecisionLevel level = DecisionLevel::in_float;  // that decided the pixel
    // Spheres that the ray does not hit: first those that the ray misses in front, then those behind the eye; the nearest of each
    // first.
    std::vector<SphereOnLine> passed{};

    // The number of the sphere that the pixel shows, or visible_background.
    std::int32_t visible() const { return hits.empty() ? visible_background : hits.front().number; }
};

// The most hits that a window shows: a ray may hit thousands.
inline constexpr std::size_t most_hits_explained = 20;
inline constexpr std::size_t most_passed_explained = 4;
// The most hits that `explain` lists: each takes kilobytes.
inline constexpr std::size_t most_hits_listed = 1000;

// Explains a pixel inside the picture. `drawn`: by `camera`. With the picture's `lists` tries only the spheres in the pixel's
// lists, and finds the same hits. Explains the nearest `most_hits`: each takes some 20 microseconds. Of passed spheres explains at
// most `most_passed` in front and as many behind the eye; for these it goes through the whole scene.
PixelExplanation explain_pixel(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size, Pixel pixel,
                               const CandidateLists* lists = nullptr,
                               std::size_t most_hits = std::numeric_limits<std::size_t>::max(), std::size_t most_passed = 0);

// The words of explanations: "sphere 2 'sun'" or "the background".
std::string called(const Scene& scene, std::int32_t number);
std::string vector_in_words(const glm::dvec3& v);

// O and D with their names.
std::string origin_in_words(const PixelExplanation& explanation);
std::string direction_in_words(const PixelExplanation& explanation);

// Where a sphere without a positive root is.
const char* behind_in_words(const PixelExplanation& explanation);

// The root that counts, and why.
const char* why(const ExplainedHit& hit);

// The level that decided a pixel, in words.
const char* level_in_words(DecisionLevel level);

// The numbers of a hit.
struct HitInWords {
    std::string a;
    std::string b;
    std::string c;
    std::string discriminant;
    std::string roots;  // their number by the discriminant: "> 0: two roots"
    std::string t1;
    std::string t2;
    std::string t;
    std::string point;
    std::string normal;
};
HitInWords in_words(const ExplainedHit& hit);

}  // namespace sphereview

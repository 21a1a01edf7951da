// Everything about one pixel: the numbers that decide what it shows.
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

// Which root of the quadratic is the hit, and so why.
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
    int discriminant_sign = 0;  // exact: -1 is passed by, 0 tangent, 1 two roots
    double t1 = 0.0;            // where it is met
    double t2 = 0.0;
};

// One that the ray hits.
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
    std::int64_t farther = 0;        // hits beyond these, where not all were asked for
    std::int64_t missed = 0;         // discriminant below 0
    std::int64_t behind = 0;         // no positive root
    std::int64_t hidden = 0;
    std::int64_t elsewhere = 0;                     // not tried, for they are in no list of the pixel: missed or behind
    DecisionLevel level = DecisionLevel::in_float;  // what it took
    // Spheres that the ray does not hit: those that its line passes by in front first, then those that it meets behind the eye
    // alone; the nearest of each first.
    std::vector<SphereOnLine> passed{};

    // The number of the sphere that the pixel shows, or visible_background.
    std::int32_t visible() const { return hits.empty() ? visible_background : hits.front().number; }
};

// As many as a window shows: a ray may hit thousands, and the window waits.
inline constexpr std::size_t most_hits_explained = 20;
inline constexpr std::size_t most_passed_explained = 4;
// As many as a person could read: each takes kilobytes.
inline constexpr std::size_t most_hits_listed = 1000;

// A pixel inside the picture that `camera` sees, with the spheres that are drawn for the camera. With the lists of the picture it
// tries only the spheres in the pixel's lists, and finds the same hits. It explains so many of them, the nearest: each takes some
// 20 microseconds. Of the spheres that are passed it explains at most so many in front and so many behind the eye; for these it
// goes through the whole scene.
PixelExplanation explain_pixel(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size, Pixel pixel,
                               const CandidateLists* lists = nullptr,
                               std::size_t most_hits = std::numeric_limits<std::size_t>::max(), std::size_t most_passed = 0);

// What an explanation says in words, for whoever shows it: "sphere 2 'sun'" or "the background".
std::string called(const Scene& scene, std::int32_t number);
std::string vector_in_words(const glm::dvec3& v);

// O and D, with what they are.
std::string origin_in_words(const PixelExplanation& explanation);
std::string direction_in_words(const PixelExplanation& explanation);

// Where a sphere without a positive root is.
const char* behind_in_words(const PixelExplanation& explanation);

// Which root counts, and why.
const char* why(const ExplainedHit& hit);

// What it took to decide a pixel.
const char* level_in_words(DecisionLevel level);

// The numbers of a hit.
struct HitInWords {
    std::string a;
    std::string b;
    std::string c;
    std::string discriminant;
    std::string roots;  // how many, by the discriminant: "> 0: two roots"
    std::string t1;
    std::string t2;
    std::string t;
    std::string point;
    std::string normal;
};
HitInWords in_words(const ExplainedHit& hit);

}  // namespace sphereview

// Ray tracers with usual mistakes.
#pragma once

#include <array>
#include <compare>
#include <string_view>
#include <vector>

#include "scene/camera.hpp"

namespace sphereview {

// The names of a mistake: `name` for programs, `words` for people.
struct MistakeWords {
    std::string_view name;
    std::string_view words;
};

// The directions of the picture's x and y. In this and the next enums the first value is right, the others are mistakes.
enum class Orientation { right, y_down, x_mirrored, turned, swapped };
inline constexpr std::array<MistakeWords, 5> orientation_words = {{
    {"", ""},
    {"y-down", "y points down: the picture is upside down"},
    {"x-mirrored", "x is mirrored: left and right are exchanged"},
    {"turned", "x and y are both mirrored: the picture is turned by half"},
    {"x-y-exchanged", "rows and columns are exchanged"},
}};

// The points of the screen that rays go through.
enum class RayPlace { center, top_left, top_right, bottom_left, bottom_right, edges, stretched };
inline constexpr std::array<MistakeWords, 7> ray_place_words = {{
    {"", ""},
    {"top-left-corner", "rays go through the top left corners of the pixels instead of their centres"},
    {"top-right-corner", "rays go through the top right corners of the pixels instead of their centres"},
    {"bottom-left-corner", "rays go through the bottom left corners of the pixels instead of their centres"},
    {"bottom-right-corner", "rays go through the bottom right corners of the pixels instead of their centres"},
    {"edge-to-edge", "the first and last pixels' rays go through the screen's edges: x / (W - 1) instead of (x + 0.5) / W"},
    {"stretched", "the square screen is stretched over a picture that is not square"},
}};

// The root of the quadratic that counts.
enum class RootRule { right, far_root, inside_missed };
inline constexpr std::array<MistakeWords, 3> root_rule_words = {{
    {"", ""},
    {"far-root", "the far root counts: t2 = (-b + sqrt(discriminant)) / (2 a) instead of t1"},
    {"inside-missed", "a sphere around the eye is missed: t2 is not tried where t1 is negative"},
}};

// Where roots may lie.
enum class SideRule { in_front, behind };
inline constexpr std::array<MistakeWords, 2> side_rule_words = {{
    {"", ""},
    {"behind-the-eye", "what lies behind the eye counts: a negative t is not left out"},
}};

// The rule for the existence of roots.
enum class DiscriminantRule { right, tangent_missed, without_four };
inline constexpr std::array<MistakeWords, 3> discriminant_rule_words = {{
    {"", ""},
    {"tangent-missed", "a tangent ray counts as a miss: discriminant > 0 instead of >= 0"},
    {"discriminant", "the discriminant is b^2 - a c instead of b^2 - 4 a c"},
}};

// The hit that is shown.
enum class HitRule { nearest, last_of_equals, first_in_file, last_in_file, farthest };
inline constexpr std::array<MistakeWords, 5> hit_rule_words = {{
    {"", ""},
    {"last-of-equals", "of equally near spheres the last in the file is shown: <= instead of < in the depth test"},
    {"no-depth-test", "no depth test: the first sphere in the file that is hit is shown"},
    {"last-in-file", "no depth test: each hit overwrites the one before, so the last in the file is shown"},
    {"farthest", "the farthest hit is shown: the depth test is the wrong way round"},
}};

// A tracer and its mistakes; the default makes none.
struct WrongTracer {
    Orientation orientation = Orientation::right;
    RayPlace place = RayPlace::center;
    RootRule root = RootRule::right;
    SideRule side = SideRule::in_front;
    DiscriminantRule discriminant = DiscriminantRule::right;
    HitRule rule = HitRule::nearest;

    auto operator<=>(const WrongTracer&) const = default;
};

// The tracers with one mistake more that can make a difference in a picture of that size.
std::vector<WrongTracer> with_one_more_mistake(const WrongTracer& tracer, PictureSize size);

// The camera whose right picture shows the tracer's mistakes of orientation and place. Rounding moves a ray by some 1e-16 of the
// picture's size, far less than any two mistakes differ.
Camera seen_wrongly(Camera camera, const WrongTracer& tracer, PictureSize size);

// The mistakes of a tracer, one each.
std::vector<MistakeWords> mistakes_of(const WrongTracer& tracer);

}  // namespace sphereview

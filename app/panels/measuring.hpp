// Measuring between spheres: two give their distance, a third the angle, a fourth the dihedral.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "panels/panel_context.hpp"

namespace sphereview {

// The angle between the ways from `b` to `a` and to `c`, in degrees, 0 to 180; nothing where a way has no length.
std::optional<double> angle_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

// Along the way from `b` to `c`: how far `d` is turned from `a`, in degrees, above -180 to 180; positive where that is clockwise
// for who looks from `b` to `c`, as chemists have it. In left-handed coordinates (`left_handed`) the same is seen. Nothing where
// three points lie on a line.
std::optional<double> dihedral_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d,
                                  bool left_handed);

inline constexpr std::size_t most_measured = 4;

struct Measuring {
    bool on = false;
    std::vector<std::uint32_t> spheres{};  // in the order in which they were clicked, at most most_measured
    std::uint64_t revision = 0;            // Document::names_revision() in which these are the spheres' numbers
    // Of the window, when it was last looked whether it covers what is to be seen.
    ImVec2 size{};
    std::size_t measured = 0;
    std::optional<ImVec2> placed{};  // where it was put then; it is elsewhere once the person has dragged it
};

// Takes a sphere that was clicked; one behind the last that is possible begins anew.
void measure(Measuring& measuring, const Document& document, std::uint32_t sphere);

struct Measure {
    std::string name;    // "distance 'sun' to sphere 3"
    double value = 0.0;  // in the scene's units, or degrees
    bool is_angle = false;
    std::size_t middle = 0;  // of an angle: its vertex; of a distance: its first sphere; places among the measured spheres
};

// What the spheres' centres give; `left_handed`: the coordinates, as they are seen. Nothing once they have other numbers.
std::vector<Measure> measures_of(const Measuring& measuring, const Scene& scene, bool left_handed);
// "12.5", "109.47°", with so many digits.
std::string value_text(const Measure& measure, int significant);
// "distance ... = 12.5", "... = 109.47°"; in full, or with 6 digits.
std::string in_words(const Measure& measure, bool in_full);

// Draws a window of its own in the area, which is the picture's, while measuring is on: at first in its upper left corner, or at
// the nearest place where it covers none of the `marks`, which are what else is drawn over the picture. When it grows over these,
// or over one of the `places`, where the measured spheres are seen, it goes where it covers none. It can be moved within the area;
// from there it gives way to measured spheres alone. Widgets: "measuring", "measure copy", "measure again", "measure end".
void draw_measuring(const PanelContext& context, Measuring& measuring, const Rectangle& area,
                    const std::vector<ImVec2>& places = {}, const std::vector<Rectangle>& marks = {});

}  // namespace sphereview

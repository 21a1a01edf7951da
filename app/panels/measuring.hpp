// Measures between clicked spheres: two give a distance, three an angle, four a dihedral.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "panels/panel_context.hpp"

namespace sphereview {

// The angle at `b` between `a` and `c` in degrees, 0 to 180; nothing if `b` equals one of them.
std::optional<double> angle_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

// The dihedral of the four points in degrees, above -180 to 180: seen from `b` to `c`, `d` is turned clockwise from `a` where it is
// positive, also in left-handed coordinates (`left_handed`). Nothing if three successive points lie on a line.
std::optional<double> dihedral_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d,
                                  bool left_handed);

inline constexpr std::size_t most_measured = 4;

struct Measuring {
    bool on = false;
    std::vector<std::uint32_t> spheres{};  // in the order of the clicks, at most most_measured
    std::uint64_t revision = 0;            // Document::names_revision() for which these numbers hold
    // The window at the last search for a free place.
    ImVec2 size{};
    std::size_t measured = 0;
    std::optional<ImVec2> placed{};  // where it was put; elsewhere if the person dragged it
};

// Adds a clicked sphere; a fifth one begins anew.
void measure(Measuring& measuring, const Document& document, std::uint32_t sphere);

struct Measure {
    std::string name;    // "distance 'sun' to sphere 3"
    double value = 0.0;  // in the scene's units, or degrees
    bool is_angle = false;
    std::size_t middle = 0;  // an angle's vertex or a distance's first sphere: place among the measured spheres
};

// The measures of the spheres' centres; none once numbers have changed. `left_handed`: the coordinates, as they are seen.
std::vector<Measure> measures_of(const Measuring& measuring, const Scene& scene, bool left_handed);
// "12.5", "109.47°", with so many digits.
std::string value_text(const Measure& measure, int significant);
// "distance ... = 12.5", "... = 109.47°"; in full, or with 6 digits.
std::string in_words(const Measure& measure, bool in_full);

// While measuring is on, draws a window in the picture's `area`: near its upper left corner, clear of the `marks` over the picture.
// When it grows over one of these, or of the measured spheres' `places`, it moves to a free place. The person can drag it within
// the area; from there it gives way to measured spheres alone. Widgets: "measuring", "measure copy", "measure again", "measure
// end".
void draw_measuring(const PanelContext& context, Measuring& measuring, const Rectangle& area,
                    const std::vector<ImVec2>& places = {}, const std::vector<Rectangle>& marks = {});

}  // namespace sphereview

// Colours and sizes by what the scene's file holds of each sphere: chosen in the side panel, and shown by the picture's legend.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "look/coloring.hpp"
#include "look/sizes.hpp"
#include "panels/number_field.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

// Colours that the spheres were given, and why they are as they are.
struct UsedColors {
    ColorBy by;
    Coloring coloring;
    std::uint64_t gesture = 0;  // in which they were given; of one gesture the last are kept
};

// How many spheres have a value in each part of a span of numbers; the parts are equal, of logarithms where the colours are by
// these.
struct Histogram {
    ValueRange span{};
    std::vector<std::size_t> counts;
};

// The colours and radii that the spheres had before a property gave them others: what is not known is empty.
struct OwnLook {
    std::uint64_t order = 0;  // Document::order_revision() in which these are of its spheres
    std::vector<Color> colors{};
    std::vector<double> radii{};
    // Chosen instead of a property's, also where the command line asks for these.
    bool colors_chosen = false;
    bool sizes_chosen = false;
};

// What the part of the side panel remembers from redraw to redraw.
struct LookPanelState {
    ColorBy colors{};                  // what is chosen; without a property: nothing yet
    std::optional<ColorMap> last_map;  // that was chosen for numbers
    std::string size_by;               // likewise; or the radii of elements, in words
    double scale = 1.0;                // the radius of a value of 1
    OwnLook own;
    bool has_sized = false;  // the radii are not the spheres' own
    // Chosen, and to be done as soon as the property is read.
    bool recolors = false;
    bool resizes = false;

    // The latest first. The spheres may have others by now, and have these again after an undo.
    std::vector<UsedColors> used;
    std::optional<Coloring> shown;  // of the latest that the spheres have now
    std::uint64_t shown_revision = 0;

    // Of the chosen property, at this revision of the scene.
    Histogram histogram;
    std::optional<ValueRange> data_range;
    std::string counted_property;
    bool counted_log = false;
    std::uint64_t counted_revision = 0;
    // Whether the values of a property are shown by category, of spheres in that order.
    std::string judged_property;
    std::uint64_t judged_revision = 0;
    bool by_category = false;

    std::optional<int> handle;  // of the range, in the hand: 0 is `low`; the histogram's span stands still meanwhile

    bool asks_for_seen = false;                      // whoever knows what the picture shows gives it
    std::optional<std::vector<std::uint32_t>> seen;  // then: the spheres, ascending
    std::string fault;                               // why the latest choice cannot be
};

// What the spheres' colours stand for, for the legend: the latest that was chosen, as far as most of them have it. Null where
// nothing was, or they have others.
const Coloring* shown_coloring(const Document& document, LookPanelState& state);

// The radii of elements that are chosen for sizes.
std::optional<RadiiKind> chosen_radii(const LookPanelState& state);

// Notes that the spheres have been given these colours.
void note_colors(LookPanelState& state, UsedColors colors);

// Draws into the current ImGui window. Widgets: "colour by", "colour by NAME", "colour by own", "size by", "size by NAME",
// "size by own", and those of draw_look_range().
void draw_look_panel(const PanelContext& context, LookPanelState& state, NumberFields& numbers);

// The part for colours by numbers: how many spheres have which, the map, and the range, as two handles and typed. Where the person
// has chosen another map or range, which `state.colors` has then: the gesture in which the spheres are to get these colours.
// Widgets: "map", "map NAME", "histogram", "handle from", "handle to", "slider from", "slider to", "logarithm", "range of data",
// "range of seen".
std::optional<std::uint64_t> draw_look_range(const PanelContext& context, LookPanelState& state, NumberFields& numbers,
                                             const Property& values);

}  // namespace sphereview

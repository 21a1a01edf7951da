// Colours and sizes by properties of the scene's file: chosen in the side panel, and explained by the picture's legend.
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

// Colours that the spheres were given, and the choice behind them.
struct UsedColors {
    ColorBy by;
    Coloring coloring;
    std::uint64_t gesture = 0;  // of the edit; only the last colours of a gesture are kept
};

// How many spheres have a value in each of the equal parts of a span of numbers, or of logarithms where the colours are by these.
struct Histogram {
    ValueRange span{};
    std::vector<std::size_t> counts;
};

// The colours and radii that the spheres had before a property gave them others; empty if unknown.
struct OwnLook {
    std::uint64_t order = 0;  // Document::order_revision() for which these hold
    std::vector<Color> colors{};
    std::vector<double> radii{};
    // Chosen by the person instead of a property, even if the command line asks for one.
    bool colors_chosen = false;
    bool sizes_chosen = false;
};

// The state of this part of the side panel.
struct LookPanelState {
    ColorBy colors{};                  // the choice; without a property: none yet
    std::optional<ColorMap> last_map;  // chosen for numbers
    std::string size_by;               // the chosen property, or the radii of elements in words
    double scale = 1.0;                // the radius of a value of 1
    OwnLook own;
    bool has_sized = false;  // the spheres have other radii than their own
    // Chosen, to be applied when the property is read.
    bool recolors = false;
    bool resizes = false;

    // The latest first. The spheres may have other colours now, and these again after an undo.
    std::vector<UsedColors> used;
    std::optional<Coloring> shown;  // the latest that the spheres have now
    std::uint64_t shown_revision = 0;

    // The chosen property's, at `counted_revision` of the scene.
    Histogram histogram;
    std::optional<ValueRange> data_range;
    std::string counted_property;
    bool counted_log = false;
    std::uint64_t counted_revision = 0;
    // Whether a property is shown by category, at a revision of the spheres' order.
    std::string judged_property;
    std::uint64_t judged_revision = 0;
    bool by_category = false;

    std::optional<int> handle;  // the dragged end of the range, 0: `low`; the histogram's span stands still

    bool asks_for_seen = false;                      // asks the viewer for `seen`
    std::optional<std::vector<std::uint32_t>> seen;  // the spheres that the picture shows, ascending
    std::string fault;                               // why the latest choice is impossible
};

// The colouring for the legend: the latest choice whose colours most spheres still have; else null.
const Coloring* shown_coloring(const Document& document, LookPanelState& state);

// The radii of elements, if these are the choice for sizes.
std::optional<RadiiKind> chosen_radii(const LookPanelState& state);

// Notes that the spheres have been given these colours.
void note_colors(LookPanelState& state, UsedColors colors);

// Draws into the current ImGui window. Widgets: "colour by", "colour by NAME", "colour by own", "size by", "size by NAME",
// "size by own", and those of draw_look_range().
void draw_look_panel(const PanelContext& context, LookPanelState& state, NumberFields& numbers);

// Draws the part for colours by numbers: the histogram, the map, and the range as two handles and two fields. If the person has
// changed the map or the range in `state.colors`, returns the gesture for the spheres' new colours. Widgets: "map", "map NAME",
// "histogram", "handle from", "handle to", "slider from", "slider to", "logarithm", "range of data", "range of seen".
std::optional<std::uint64_t> draw_look_range(const PanelContext& context, LookPanelState& state, NumberFields& numbers,
                                             const Property& values);

}  // namespace sphereview

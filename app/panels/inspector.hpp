// The pixel inspector: the arithmetic of a pixel, written and drawn.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "exact/explain.hpp"
#include "panels/panel_context.hpp"
#include "shade/explain_color.hpp"

namespace sphereview {

// All that an explanation depends on.
struct InspectedPlace {
    Pixel pixel;
    PictureSize size;  // of the picture that the pixel is in
    Camera camera;     // of the view
    std::uint64_t revision = 0;
    std::optional<Light> light{};  // in the shading that shows it
    bool with_passed = true;       // whether the spheres that the ray passes were looked for

    bool operator==(const InspectedPlace&) const = default;
};

// Whether a light shines on what a pixel shows.
struct InspectedLight {
    int number = 0;  // 0: the sun, else one of the sky's
    glm::dvec3 direction{0.0};
    bool shines = false;
    std::string why{};                      // or why not, in words
    std::optional<std::int32_t> blocker{};  // the sphere that keeps it away

    bool is_sun() const { return number == 0; }
};

struct InspectedPixel {
    InspectedPlace place;
    PixelExplanation explanation;
    std::optional<InspectedLight> light{};    // the sun, or else the sky's strongest; none where nothing is lit
    std::optional<ColorExplanation> color{};  // what that light makes of the sphere's colour; none where it is not known
    std::string sky{};                        // what becomes of the sky's lights, in words; "" where that is not known
};

// What is inspected.
struct Inspection {
    std::optional<InspectedPixel> first{};   // pinned, or under the pointer, or what was last under it
    std::optional<InspectedPixel> second{};  // pinned beside the first, to be compared with it
    bool pinned = false;                     // the first
    bool second_is_next = false;             // the next click pins the second
};

// What the inspector remembers from redraw to redraw.
struct InspectorState {
    std::optional<std::int32_t> subject;  // the sphere that the drawings are about; by default what the pixel shows
    bool second_in_detail = false;        // of two pixels
};

// Draws into the current ImGui window. Widgets: "unpin", "compare pixels", "copy explanation", "close inspector", "ray drawing",
// "quadratic drawing", "hit 3", "passed 3", "light ray", "light drawing", "light sum", "lit colour", "compared", "detail 1" and
// "detail 2".
void draw_inspector(const PanelContext& context, const Inspection& inspection, InspectorState& state);

}  // namespace sphereview

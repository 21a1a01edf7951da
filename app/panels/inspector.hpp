// The pixel inspector: the arithmetic of a pixel in words and drawings.
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
    PictureSize size;  // of the pixel's picture
    Camera camera;     // of the view
    std::uint64_t revision = 0;
    std::optional<Light> light{};  // if the shading shows light
    bool with_passed = true;       // includes the spheres that the ray passes

    bool operator==(const InspectedPlace&) const = default;
};

// Whether a light shines on what a pixel shows.
struct InspectedLight {
    int number = 0;  // 0: the sun, else one of the sky's
    glm::dvec3 direction{0.0};
    bool shines = false;
    std::string why{};                      // why not, in words
    std::optional<std::int32_t> blocker{};  // the sphere that blocks the light

    bool is_sun() const { return number == 0; }
};

struct InspectedPixel {
    InspectedPlace place;
    PixelExplanation explanation;
    std::optional<InspectedLight> light{};    // the sun, or else the sky's strongest; none without light
    std::optional<ColorExplanation> color{};  // the sphere's colour in the light; none while unknown
    std::string sky{};                        // the sky's lights in words; "" while unknown
};

struct Inspection {
    std::optional<InspectedPixel> first{};   // pinned, or under the pointer, or last under it
    std::optional<InspectedPixel> second{};  // pinned for a comparison with the first
    bool pinned = false;                     // the first
    bool second_is_next = false;             // the next click pins the second
};

// The inspector's state.
struct InspectorState {
    std::optional<std::int32_t> subject;  // the drawings' sphere; by default the one that the pixel shows
    bool second_in_detail = false;        // details are of the second pixel
};

// Draws into the current ImGui window. Widgets: "unpin", "compare pixels", "copy explanation", "close inspector", "ray drawing",
// "quadratic drawing", "hit 3", "passed 3", "light ray", "light drawing", "light sum", "lit colour", "compared", "detail 1" and
// "detail 2".
void draw_inspector(const PanelContext& context, const Inspection& inspection, InspectorState& state);

}  // namespace sphereview

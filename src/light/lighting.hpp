// Visible spheres -> the light of each pixel, decided exactly. docs/light.md.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <span>
#include <vector>

#include "exact/drawn.hpp"
#include "exact/visible.hpp"
#include "light/hit_places.hpp"
#include "light/kept_light.hpp"
#include "light/light_set.hpp"
#include "light/light_tiles.hpp"
#include "light/spatial_order.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// Previews of a picture while lights are still being added.
struct LightPreviews {
    // Gets the light of each point, as light() returns it, and the missing part of the sky's brightness, 0..1.
    std::function<void(std::span<const LightVector>, double missing)> show;
    // Whether the lights so far are scaled to the strength of all, so that nothing is missing: the picture then gets finer, not
    // brighter, and first previews have hard shadows.
    bool as_bright = true;
    std::size_t fewest = 0;     // lights before the first
    double first_after = 0.02;  // seconds of adding lights
    double every = 0.2;         // seconds, from one to the next
};

// The light of one picture, or of the points of its pixels.
class Lighting {
public:
    // `size`: in points, `side` of them along the side of a pixel. `drawn`: by this camera. The references must outlive this
    // object.
    Lighting(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size, int side, const Light& light);

    // The light of each point of a block, row by row: the sum of the shares of the lights that shine there; zero on the background.
    // `visible`: scene numbers or visible_background. Calls progress() with the finished part, 0..1, from this thread. Previews
    // need one point a pixel. `kept`, begun with sets(), gets the result if that fits. `counts` gets the amount of work.
    std::vector<LightVector> light(const Block& block, std::span<const std::int32_t> visible,
                                   const std::function<void(double)>& progress = nullptr, const LightPreviews* previews = nullptr,
                                   KeptLight* kept = nullptr, LightCounts* counts = nullptr) const;

    const std::vector<std::vector<DirectedLight>>& sets() const { return sets_; }
    // The lights of a set, in their order.
    const std::vector<DirectedLight>& lights(int set) const { return sets_[static_cast<std::size_t>(set)]; }

private:
    // Points that lie near each other, and the spheres relative to them in float.
    struct PointGroup {
        explicit PointGroup(const HitPlaces& hit_places) : places(hit_places) {}

        HitPlaces places;
        LitPoints points;
        Blockers blockers;
        PointTrees trees;
    };

    std::list<PointGroup> point_groups(const Block& block, std::span<const std::int32_t> visible) const;

    const Scene& scene_;
    const DrawnSpheres& drawn_;
    bool sun_;               // the first light of each set
    glm::dvec3 toward_eye_;  // of length 1
    const Camera& camera_;
    PictureSize size_;
    int side_;
    SpatialGrid grid_;
    std::vector<std::uint32_t> order_;  // the drawn spheres' indices, by spatial_order()
    std::vector<EyeSide> sides_;        // the eye's, by number
    std::vector<std::vector<DirectedLight>> sets_;
};

}  // namespace sphereview

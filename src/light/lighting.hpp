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

// How a picture is shown while lights are still being added. Each preview has the light of the first lights.
struct LightPreviews {
    // Is given the light of each point, as light() returns it, and which part of the sky's brightness is missing, 0..1.
    std::function<void(std::span<const LightVector>, double missing)> show;
    // Whether the sky is made as strong as it will be with all lights, so that nothing is missing: the picture gets finer and no
    // brighter. Few lights have hard shadows then.
    bool as_bright = true;
    std::size_t fewest = 0;     // lights before the first
    double first_after = 0.02;  // seconds of adding lights
    double every = 0.2;         // seconds, from one to the next
};

// The light of one picture, or of the points of its pixels.
class Lighting {
public:
    // `size`: in points, `side` of them along the side of a pixel. `drawn` is as the camera sees it. What is passed in must outlive
    // it.
    Lighting(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size, int side, const Light& light);

    // The light of each point of a block, row by row, from its visible spheres (scene numbers or visible_background); zero where
    // there is none. The sum of the shares of the lights that shine there; its product with the normal is the brightness. Calls
    // progress() now and then, from this thread, with the part that is done, 0..1. Previews are of pictures with one point a pixel
    // only. `kept` is given what was found, if that fits; it was begun with the sets of lights. `counts` is told how much there was
    // to do.
    std::vector<LightVector> light(const Block& block, std::span<const std::int32_t> visible,
                                   const std::function<void(double)>& progress = nullptr, const LightPreviews* previews = nullptr,
                                   KeptLight* kept = nullptr, LightCounts* counts = nullptr) const;

    const std::vector<std::vector<DirectedLight>>& sets() const { return sets_; }
    // The lights of a set, in their order.
    const std::vector<DirectedLight>& lights(int set) const { return sets_[static_cast<std::size_t>(set)]; }

private:
    // Points that lie near each other, as LitPoints have them, with what floats tell of the spheres from there.
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
    std::vector<std::uint32_t> order_;  // of the drawn spheres' indices, in space
    std::vector<EyeSide> sides_;        // the eye's, by number
    std::vector<std::vector<DirectedLight>> sets_;
};

}  // namespace sphereview

// How a ray tracer with usual mistakes sees a scene: for each pixel the number of the sphere that it would show.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "mistakes/wrong_tracer.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// What wrong tracers see of a scene from its own camera, in pictures of one size. The scene must outlive it.
class WrongPictures {
public:
    // Throws MemoryError when what is kept cannot fit.
    WrongPictures(const Scene& scene, PictureSize size);
    ~WrongPictures();

    PictureSize size() const { return size_; }

    // Whether the tracer's picture takes so long that it is not worth its time: where rays hit nearly all spheres.
    bool takes_too_long(const WrongTracer& tracer) const;

    // Forgets the numbers of tracers with several mistakes: another picture seldom needs them.
    void forget_combinations();

    // Row by row the number of the sphere that each pixel shows, or visible_background. Made at the first call and kept.
    const std::vector<std::int32_t>& numbers(const WrongTracer& tracer);

    // The numbers, perhaps visible_background among them, of what float arithmetic without care may show in a pixel instead of
    // the right sphere. One number where it surely sees the right one.
    std::vector<std::int32_t> numbers_in_float(Pixel pixel);

private:
    struct FloatView;

    const Scene& scene_;
    PictureSize size_;
    std::map<WrongTracer, std::vector<std::int32_t>> numbers_;
    std::unique_ptr<FloatView> float_view_;
};

}  // namespace sphereview

// Pictures of a scene by ray tracers with usual mistakes, as numbers of spheres.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "mistakes/wrong_tracer.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// The pictures by the scene's own camera, of one size. The scene must outlive this object.
class WrongPictures {
public:
    // Throws MemoryError when the numbers cannot fit.
    WrongPictures(const Scene& scene, PictureSize size);
    ~WrongPictures();

    PictureSize size() const { return size_; }

    // Whether the tracer's picture takes too long, because rays hit nearly all spheres.
    bool takes_too_long(const WrongTracer& tracer) const;

    // Forgets the numbers of tracers with several mistakes: another picture seldom needs them.
    void forget_combinations();

    // The number of the sphere that each pixel shows, or visible_background, row by row. Made at the first call and kept.
    const std::vector<std::int32_t>& numbers(const WrongTracer& tracer);

    // The numbers, perhaps with visible_background, that careless float arithmetic may show in a pixel: the right one alone if that
    // is sure.
    std::vector<std::int32_t> numbers_in_float(Pixel pixel);

private:
    struct FloatView;

    const Scene& scene_;
    PictureSize size_;
    std::map<WrongTracer, std::vector<std::int32_t>> numbers_;
    std::unique_ptr<FloatView> float_view_;
};

}  // namespace sphereview

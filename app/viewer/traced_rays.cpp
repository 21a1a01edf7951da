#include "viewer/traced_rays.hpp"

#include "base/parallel.hpp"
#include "camera/navigation.hpp"
#include "cpu/cpu_renderer.hpp"
#include "exact/explain.hpp"
#include "exact/resolve.hpp"
#include "tiles/build_lists.hpp"

namespace sphereview {

namespace {

constexpr std::size_t rays_at_once = 16;
constexpr int usual_cells = 26;  // along the shorter side, at most
constexpr int usual_in_row = 60;
constexpr int most_every = 1 << 14;

// Where the ray meets a sphere that it is known to hit.
glm::dvec3 point_on(const Sphere& sphere, const Camera& camera, PictureSize size, Pixel pixel, const glm::dvec3& otherwise) {
    Scene alone;
    alone.spheres = {sphere};
    const PixelExplanation found = explain_pixel(alone, drawn_spheres(alone, camera), camera, size, pixel, nullptr, 1);
    return found.hits.empty() ? otherwise : found.hits.front().point;
}

}  // namespace

std::vector<Pixel> pixels_of_rays(PictureSize size, const RayChoice& choice, int row) {
    std::vector<Pixel> pixels;
    if (choice.shown == RaysShown::one) return pixels;
    const bool alone = choice.shown == RaysShown::row;
    const PixelGrid grid(size, choice.every());
    const auto [columns, rows] = grid.size();
    for (int j = 0; j < (alone ? 1 : rows); ++j) {
        const int y = alone ? row : grid.traced_row(j);
        for (int i = 0; i < columns; ++i) pixels.push_back({grid.traced_column(i), y});
    }
    return pixels;
}

int least_every(PictureSize size, RaysShown shown) {
    int every = 1;
    const auto count = [&] {
        const PictureSize cells = PixelGrid(size, every).size();
        return static_cast<std::size_t>(cells.width) * static_cast<std::size_t>(shown == RaysShown::all ? cells.height : 1);
    };
    while (every < most_every && count() > most_rays) every *= 2;
    return every;
}

int usual_every(PictureSize size, RaysShown shown) {
    const int most = shown == RaysShown::row ? usual_in_row : usual_cells;
    int every = least_every(size, shown);
    while (every < most_every && size.shorter_side() > most * every) every *= 2;
    return every;
}

std::vector<TracedRay> trace_rays(const Scene& scene, const Camera& camera, PictureSize size, std::span<const Pixel> pixels,
                                  double far_depth) {
    const DrawnSpheres drawn = drawn_spheres(scene, camera);
    const CandidateLists lists = build_lists(drawn, camera, PixelGrid(size), cpu_tile_costs);
    const Resolver resolver(scene, drawn, camera, size, &lists);
    std::vector<TracedRay> rays(pixels.size());
    parallel_pieces(pixels.size(), rays_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Pixel pixel = pixels[i];
            const glm::dvec2 middle(pixel.x + 0.5, pixel.y + 0.5);
            TracedRay& ray = rays[i];
            DecisionLevel level = DecisionLevel::in_float;
            ray.pixel = pixel;
            ray.visible = resolver.resolve(pixel, level);
            ray.from = point_at(camera, size, middle, 0.0);
            ray.to = point_at(camera, size, middle, far_depth);
            if (ray.visible < 0) continue;
            ray.to = point_on(scene.spheres[static_cast<std::size_t>(ray.visible)], camera, size, pixel, ray.to);
        }
    });
    return rays;
}

}  // namespace sphereview

#include "light/lighting.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <utility>

#include "base/parallel.hpp"
#include "exact/exact_decision.hpp"

namespace sphereview {

namespace {

// What one thread needs to add lights: its own sums, because whole numbers may be added in any order.
struct Worker {
    LightTiles tiles;
    std::vector<LightVector> sums;  // by point
};

// More threads would take more memory than they save time.
constexpr std::size_t most_workers = 16;

constexpr std::size_t points_at_once = 16384;

struct Job {
    std::size_t set;
    const DirectedLight* light;
};

// Whether a light shines on a point of which float knows too little: every sphere is asked.
bool shines(const LitScene& lit_scene, const PointOrigin& origin, const glm::dvec3& direction) {
    const Pixel pixel = lit_scene.pixel(origin);
    const Sphere& sphere = lit_scene.sphere(origin.number);
    const EyeSide side = lit_scene.side(origin.number);
    if (!lit_scene.places.faces(pixel, sphere, side, direction)) return false;
    const auto blocks = [&](std::int32_t other) {
        return other != origin.number && lit_scene.places.blocked(pixel, sphere, side, lit_scene.sphere(other), direction);
    };
    return std::ranges::none_of(lit_scene.blockers.numbers, blocks) && std::ranges::none_of(lit_scene.blockers.far, blocks);
}

}  // namespace

Lighting::Lighting(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size, int side,
                   const Light& light)
    : scene_(scene), drawn_(drawn), side_(side), places_(camera, size), sides_(scene.spheres.size(), EyeSide::outside) {
    auto gap = drawn.gone.begin();
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (gap != drawn.gone.end() && *gap == i) {
            ++gap;
        } else {
            sides_[static_cast<std::size_t>(drawn.number(i))] = drawn.side(i);
        }
    }
    const int lights = sky_lights(light, scene.spheres.size(), side * side);
    for (int set = 0; set < side * side; ++set) sets_.push_back(light_set(light, lights, camera, set));
}

std::vector<LightVector> Lighting::light(const Block& block, std::span<const std::int32_t> visible,
                                         const std::function<void(double)>& progress) const {
    const LitPoints points = lit_points(scene_, places_, sides_, block, visible, side_);
    const Blockers all_blockers = blockers(scene_, drawn_, places_.eye(), points);
    const LitScene lit_scene{scene_, places_, sides_, block, points, all_blockers};

    std::vector<Job> jobs;
    for (std::size_t set = 0; set < sets_.size(); ++set) {
        if (points.begins.at(set) == points.begins.at(set + 1)) continue;
        for (const DirectedLight& light : sets_[set]) jobs.push_back({set, &light});
    }

    // Light by light: each thread takes the next one, and adds to sums of its own.
    std::vector<Worker> workers;
    std::mutex joining;
    std::atomic<std::size_t> next = 0;
    const auto caller = std::this_thread::get_id();
    parallel_for(std::min({jobs.size(), most_workers, static_cast<std::size_t>(worker_count())}), [&](std::size_t) {
        Worker worker;
        worker.sums.resize(points.size());
        for (std::size_t i = next++; i < jobs.size(); i = next++) {
            check_cancelled();
            const auto& [set, light] = jobs[i];
            const std::size_t begin = points.begins.at(set);
            const std::size_t end = points.begins.at(set + 1);
            for (const std::uint32_t point : worker.tiles.lit(lit_scene, begin, end, light->direction)) {
                worker.sums[point] += light->share;
            }
            if (progress && std::this_thread::get_id() == caller) {
                progress(static_cast<double>(i) / static_cast<double>(jobs.size()));
            }
        }
        const std::lock_guard lock(joining);
        workers.push_back(std::move(worker));
    });

    std::vector<LightVector> lit(visible.size());
    parallel_pieces(points.size(), points_at_once, [&](std::size_t begin, std::size_t end) {
        for (const Worker& worker : workers) {
            for (std::size_t i = begin; i < end; ++i) lit[static_cast<std::size_t>(points.origins[i].place)] += worker.sums[i];
        }
    });
    parallel_for(points.unknown.size(), [&](std::size_t i) {
        const PointOrigin& origin = points.unknown[i];
        for (const DirectedLight& light : lights(side_ == 1 ? 0 : set_of(lit_scene.pixel(origin), side_))) {
            check_cancelled();
            if (shines(lit_scene, origin, light.direction)) lit[static_cast<std::size_t>(origin.place)] += light.share;
        }
    });
    return lit;
}

}  // namespace sphereview

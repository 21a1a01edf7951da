#include "light/lighting.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <thread>
#include <utility>

#include "base/parallel.hpp"
#include "base/square_root.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

// More threads would take more memory than they save time.
constexpr std::size_t most_workers = 16;

constexpr std::size_t points_at_once = 16384;

// More would take more time than they save.
constexpr std::size_t most_groups = 8;

// So many lights of the sky show what will become of it.
constexpr std::size_t enough_for_first_preview = 16;

struct Job {
    std::size_t set;
    std::size_t place;  // in the set
    const DirectedLight* light;
};

// How bright a light makes a sphere, as the eye sees it in the middle of the picture: the mean of max(n.L, 0) over the disc that is
// seen, times a constant, which is Lambert's law of the moon's phases.
double brightness(const LightVector& share, const glm::dvec3& toward_eye) {
    const glm::dvec3 light{static_cast<double>(share.x), static_cast<double>(share.y), static_cast<double>(share.z)};
    const double strength = square_root(dot(light, light));
    const double phase = std::acos(std::clamp(dot(light, toward_eye) / strength, -1.0, 1.0));
    return strength * (std::sin(phase) + (std::numbers::pi - phase) * std::cos(phase));
}

// Light by light: each thread takes the next one, and adds to the sums when the light is decided: whole numbers may be added in any
// order.
class LightSums {
public:
    LightSums(std::span<const LitScene> groups, std::vector<Job> jobs, const std::function<void(double)>& progress, bool keeps)
        : jobs_(std::move(jobs)),
          progress_(progress),
          workers_(std::min({jobs_.size(), most_workers, static_cast<std::size_t>(worker_count())})) {
        std::size_t count = 0;
        for (const LitScene& lit_scene : groups) {
            groups_.push_back({lit_scene, count, std::vector<Shining>(keeps ? jobs_.size() : 0)});
            count += lit_scene.points.size();
        }
        sums_.resize(count);
    }

    std::size_t size() const { return jobs_.size(); }
    std::size_t added() const { return added_; }
    std::size_t threads() const { return workers_.size(); }
    const DirectedLight& light(std::size_t i) const { return *jobs_[i].light; }

    // The next lights.
    void add(std::size_t count) {
        const std::size_t end = added_ + count;
        std::atomic<std::size_t> next = added_;
        const auto caller = std::this_thread::get_id();
        parallel_for(workers_.size(), [&](std::size_t which) {
            LightTiles& tiles = workers_[which];
            for (std::size_t i = next++; i < end; i = next++) {
                check_cancelled();
                const auto& [set, place, light] = jobs_[i];
                for (Group& group : groups_) {
                    const std::size_t first = group.lit_scene.points.begins.at(set);
                    if (group.lit_scene.points.has_none_of(set)) continue;
                    const std::span<const std::uint64_t> lit = tiles.lit(group.lit_scene, set, light->direction);
                    if (!group.shining.empty()) group.shining[i] = {set, place, {lit.begin(), lit.end()}};
                    add_share(group.begin + first, lit, light->share);
                }
                if (progress_ && std::this_thread::get_id() == caller) {
                    progress_(static_cast<double>(i) / static_cast<double>(jobs_.size()));
                }
            }
        });
        added_ = end;
    }

    // use(place, sum), on all cores.
    template <typename Use>
    void for_each_point(const Use& use) const {
        for (const Group& group : groups_) {
            parallel_pieces(group.lit_scene.points.size(), points_at_once, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                    use(static_cast<std::size_t>(group.lit_scene.points.places[i]), sums_[group.begin + i]);
                }
            });
        }
    }

    // Gives back what deciding takes. Returns how much there was to do.
    LightCounts finish() {
        LightCounts counts;
        for (const LightTiles& tiles : workers_) counts += tiles.counts();
        workers_ = {};
        return counts;
    }

    // What was found of each group, if that is kept.
    std::vector<FoundLight> found(std::size_t sets) {
        std::vector<FoundLight> all;
        for (Group& group : groups_) {
            const LitPoints& points = group.lit_scene.points;
            all.push_back({points.places, std::span(points.begins).first(sets + 1), std::move(group.shining)});
        }
        return all;
    }

private:
    // To the points from `first` on whose bits are set. Threads that add at the same time are mostly in different parts. The points
    // of a word are added to under one lock: that of the part where it begins.
    void add_share(std::size_t first, std::span<const std::uint64_t> lit, const LightVector& share) {
        constexpr std::size_t in_word = 64;
        const std::size_t words_in_part = sums_.size() / in_word / joining_.size() + 1;
        for (std::size_t word = 0; word < lit.size();) {
            const std::size_t part = (first / in_word + word) / words_in_part;
            const std::size_t end = std::min(lit.size(), (part + 1) * words_in_part - first / in_word);
            const std::lock_guard lock(joining_.at(part));
            for (; word < end; ++word) {
                for (std::uint64_t rest = lit[word]; rest != 0; rest &= rest - 1) {
                    sums_[first + in_word * word + static_cast<std::size_t>(std::countr_zero(rest))] += share;
                }
            }
        }
    }

    struct Group {
        const LitScene& lit_scene;
        std::size_t begin;             // of its sums
        std::vector<Shining> shining;  // by job, if it is kept
    };

    std::vector<Group> groups_;
    std::vector<Job> jobs_;
    const std::function<void(double)>& progress_;
    std::vector<LightTiles> workers_;
    std::vector<LightVector> sums_;       // by point, group by group
    std::array<std::mutex, 64> joining_;  // of parts of the sums
    std::size_t added_ = 0;
};

// Adds all lights, the first of which is the sun if there is one, and shows how they grow.
void add_shown(LightSums& sums, bool sun, const glm::dvec3& toward_eye, const LightPreviews& previews, std::size_t pixels) {
    const auto begin = std::chrono::steady_clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
    std::vector<LightVector> of_sun(sun ? pixels : 0);
    const std::size_t suns = sun ? 1 : 0;
    if (sun) {
        sums.add(1);
        sums.for_each_point([&](std::size_t place, const LightVector& sum) { of_sun[place] = sum; });
    }
    double all = 0.0;
    for (std::size_t i = suns; i < sums.size(); ++i) all += brightness(sums.light(i).share, toward_eye);
    bool any = false;
    double so_far = 0.0;
    while (sums.added() < sums.size()) {
        // Adds as many lights as there is time for.
        const std::size_t known = sums.added() - suns;
        const double for_each = seconds() / static_cast<double>(known + suns);
        const double many = known == 0 ? 0.0 : (any ? previews.every : previews.first_after) / for_each;
        const std::size_t rest = sums.size() - sums.added();
        const std::size_t next = std::min(std::max(static_cast<std::size_t>(std::min(many, 1e6)), sums.threads()), rest);
        for (std::size_t i = 0; i < next; ++i) so_far += brightness(sums.light(sums.added() + i).share, toward_eye);
        sums.add(next);
        if (sums.added() == sums.size()) return;
        if (sums.added() < previews.fewest) continue;
        if (!any && sums.added() < enough_for_first_preview && seconds() < previews.first_after) continue;
        if (so_far == 0.0) continue;
        any = true;
        const double factor = previews.as_bright ? all / so_far : 1.0;
        std::vector<LightVector> lit(pixels);
        sums.for_each_point([&](std::size_t place, const LightVector& sum) {
            const LightVector from_sun = sun ? of_sun[place] : LightVector{};
            const auto scaled = [&](std::int32_t of_all, std::int32_t part) {
                constexpr double most = std::numeric_limits<std::int32_t>::max();
                const double value = static_cast<double>(part) + factor * static_cast<double>(of_all - part);
                return static_cast<std::int32_t>(std::clamp(value, -most, most));
            };
            lit[place] = {scaled(sum.x, from_sun.x), scaled(sum.y, from_sun.y), scaled(sum.z, from_sun.z)};
        });
        previews.show(lit, previews.as_bright ? 0.0 : 1.0 - so_far / all);
    }
}

}  // namespace

Lighting::Lighting(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size, int side,
                   const Light& light)
    : scene_(scene),
      drawn_(drawn),
      sun_(light.sun.has_value()),
      toward_eye_(-camera_axes(camera).ahead),
      camera_(camera),
      size_(size),
      side_(side),
      grid_(scene, drawn),
      order_(spatial_order(scene, drawn, grid_)),
      sides_(scene.spheres.size(), EyeSide::outside),
      sets_(light_sets(light, scene.spheres.size(), camera, side)) {
    // In the spheres' own order, in which memory is read fastest.
    parallel_pieces(drawn.size(), points_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (!drawn.gone.empty() && std::ranges::binary_search(drawn.gone, i)) continue;
            sides_[static_cast<std::size_t>(drawn.number(i))] = drawn.side(i);
        }
    });
}

std::list<Lighting::PointGroup> Lighting::point_groups(const Block& block, std::span<const std::int32_t> visible) const {
    std::list<PointGroup> groups;
    UninitializedVector<std::int32_t> left = shown_places(scene_, grid_, block, visible, side_);
    while (!left.empty()) {
        const bool last = groups.size() + 1 == most_groups;
        PointGroup& group = groups.emplace_back(HitPlaces(camera_, size_, scale_of_most(scene_, camera_.eye, visible, left)));
        UninitializedVector<std::int32_t> rest;
        group.points = lit_points(scene_, group.places, sides_, block, visible, side_, std::move(left), last ? nullptr : &rest);
        group.blockers = blockers(scene_, drawn_, order_, sides_, group.places, group.points);
        group.trees = point_trees(drawn_, order_, sides_, group.points, group.blockers);
        left = std::move(rest);
    }
    return groups;
}

std::vector<LightVector> Lighting::light(const Block& block, std::span<const std::int32_t> visible,
                                         const std::function<void(double)>& progress, const LightPreviews* previews,
                                         KeptLight* kept, LightCounts* counts) const {
    const std::list<PointGroup> groups = point_groups(block, visible);
    std::vector<LitScene> lit_scenes;
    for (const PointGroup& group : groups) {
        lit_scenes.push_back(
            {scene_, drawn_, order_, group.places, sides_, block, visible, group.points, group.blockers, group.trees});
    }

    std::vector<Job> jobs;
    for (std::size_t set = 0; set < sets_.size(); ++set) {
        if (std::ranges::all_of(groups, [&](const PointGroup& group) { return group.points.has_none_of(set); })) continue;
        for (std::size_t place = 0; place < sets_[set].size(); ++place) jobs.push_back({set, place, &sets_[set][place]});
    }

    std::size_t shown = 0;
    for (const PointGroup& group : groups) shown += group.points.size();
    if (kept != nullptr && !kept->has_room(visible.size(), shown)) {
        kept->give_up();
        kept = nullptr;
    }
    LightSums sums(lit_scenes, std::move(jobs), progress, kept != nullptr);
    if (previews != nullptr && side_ == 1) {
        add_shown(sums, sun_, toward_eye_, *previews, visible.size());
    } else {
        sums.add(sums.size());
    }
    const LightCounts counted = sums.finish();
    if (counts != nullptr) *counts = counted;
    if (kept != nullptr) kept->add(block, visible, sums.found(sets_.size()));
    std::vector<LightVector> lit(visible.size());
    sums.for_each_point([&](std::size_t place, const LightVector& sum) { lit[place] = sum; });
    return lit;
}

}  // namespace sphereview

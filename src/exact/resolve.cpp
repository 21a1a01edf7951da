#include "exact/resolve.hpp"

#include <atomic>
#include <cassert>
#include <cmath>
#include <vector>

#include "base/parallel.hpp"
#include "exact/exact_decision.hpp"

namespace sphereview {

namespace {

// Anything may be true.
constexpr HitBounds<double> unknown_hit = {-NearestHits<double>::never, NearestHits<double>::never};

template <typename Real>
HitBounds<Real> bounds_of_side(EyeSide side, const glm::vec<3, Real>& c, Real r, Real w, const glm::vec<3, Real>& ray) {
    switch (side) {
        case EyeSide::outside: return hit_bounds<EyeSide::outside>(c.x, c.y, c.z, r, w, ray.x, ray.y, ray.z);
        case EyeSide::inside: return hit_bounds<EyeSide::inside>(c.x, c.y, c.z, r, w, ray.x, ray.y, ray.z);
        case EyeSide::on_surface: return hit_bounds<EyeSide::on_surface>(c.x, c.y, c.z, r, w, ray.x, ray.y, ray.z);
    }
    return {};
}

HitBounds<double> bounds_in_double(const Sphere& sphere, EyeSide side, const glm::dvec3& eye, double error_scale,
                                   const glm::dvec3& ray) {
    const glm::dvec3 c = sphere.center - eye;
    const double size = std::fabs(c.x) + std::fabs(c.y) + std::fabs(c.z) + sphere.radius;
    // Also when it is not a number: then nothing is known.
    if (!(size > smallest_double_size && size < largest_double_size)) return unknown_hit;
    return bounds_of_side<double>(side, c, sphere.radius, error_scale * size, ray);
}

// Calls add(index) for the drawn spheres that a pixel can show, all of them without lists; it returns the distance of the nearest
// sure hit, in the units of the lists.
template <typename Add>
void for_each_candidate(const DrawnSpheres& drawn, const CandidateLists* lists, Pixel pixel, const Add& add) {
    if (lists == nullptr) {
        auto gap = drawn.gone.begin();
        for (std::uint32_t i = 0; i < drawn.size(); ++i) {
            if (gap != drawn.gone.end() && *gap == i) {
                ++gap;
            } else {
                add(i);
            }
        }
        return;
    }
    for (const TileLevel& level : lists->levels) {
        double sure_hit = NearestHits<double>::never;
        for (const Candidate& candidate : lists->at(level, pixel.x, pixel.y)) {
            if (ends_walk(candidate, sure_hit)) break;
            sure_hit = add(candidate.index);
        }
    }
}

}  // namespace

DecisionCounts& DecisionCounts::operator+=(const DecisionCounts& other) {
    in_float += other.in_float;
    in_double += other.in_double;
    exactly += other.exactly;
    return *this;
}

Resolver::Resolver(const Scene& scene, const DrawnSpheres& drawn, PictureSize size, const CandidateLists* lists)
    : Resolver(scene, drawn, scene.camera, size, lists) {}

Resolver::Resolver(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size,
                   const CandidateLists* lists)
    : scene_(scene),
      drawn_(drawn),
      camera_(camera),
      lists_(lists),
      size_(size),
      frame_(ray_basis<double>(camera, size)),
      error_scale_(error_scale(ray_condition(camera), double_unit)) {
    frame_.in_range = frame_.in_range && std::isfinite(error_scale_);
}

NearestHits<double> Resolver::contest(Pixel pixel, std::vector<Contest>& contests) const {
    const glm::dvec3 ray = unit_ray(frame_, size_, pixel);
    NearestHits<double> nearest;
    for_each_candidate(drawn_, lists_, pixel, [&](std::uint32_t i) {
        const Sphere& sphere = scene_.spheres[static_cast<std::size_t>(drawn_.number(i))];
        const HitBounds<double> hit =
            frame_.in_range ? bounds_in_double(sphere, drawn_.side(i), camera_.eye, error_scale_, ray) : unknown_hit;
        nearest.add(static_cast<int>(i), hit);
        if (hit.low < NearestHits<double>::never) contests.push_back({i, hit.low});
        return std::ldexp(nearest.smallest_high, drawn_.scale);
    });
    return nearest;
}

std::int32_t Resolver::resolve(Pixel pixel, DecisionLevel& level) const {
    std::vector<Contest> contests;
    const NearestHits<double> nearest = contest(pixel, contests);
    if (frame_.in_range && nearest.decided()) {
        level = DecisionLevel::in_double;
        return nearest.guess < 0 ? visible_background : drawn_.number(static_cast<std::size_t>(nearest.guess));
    }
    level = DecisionLevel::exactly;
    std::vector<Contender> contenders;
    for (const Contest& contest : contests) {
        if (contest.low > nearest.smallest_high) continue;
        const std::int32_t number = drawn_.number(contest.index);
        contenders.push_back({number, &scene_.spheres[static_cast<std::size_t>(number)]});
    }
    return decide_exactly(camera_, size_, pixel, contenders);
}

DecisionLevel decision_level(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size, Pixel pixel,
                             const CandidateLists* lists) {
    const FloatView view = float_view(camera, size, gpu_unit);
    const glm::vec3 ray = unit_ray(view.rays, size, pixel);
    NearestHits<float> nearest;
    for_each_candidate(drawn, lists, pixel, [&](std::uint32_t i) {
        const glm::vec4& s = drawn.center_radius[i];
        const float w = view.error_scale * (std::fabs(s.x) + std::fabs(s.y) + std::fabs(s.z) + std::fabs(s.w));
        const EyeSide side = s.w > 0.0F ? EyeSide::outside : s.w < 0.0F ? EyeSide::inside : EyeSide::on_surface;
        nearest.add(static_cast<int>(i), bounds_of_side<float>(side, glm::vec3(s), std::fabs(s.w), w, ray));
        return nearest.smallest_high;
    });
    if (!view.all_doubtful && nearest.decided()) return DecisionLevel::in_float;
    DecisionLevel level = DecisionLevel::in_double;
    Resolver(scene, drawn, camera, size, lists).resolve(pixel, level);
    return level;
}

DecisionCounts Resolver::certify(const Block& block, std::span<std::int32_t> visible) const {
    assert(visible.size() == static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
    std::atomic<std::int64_t> all_in_double = 0;
    std::atomic<std::int64_t> all_exactly = 0;
    const bool renumber = !drawn_.numbers.empty();
    parallel_for(static_cast<std::size_t>(block.height), [&](std::size_t row) {
        std::int64_t in_double = 0;
        std::int64_t exactly = 0;
        std::int32_t* numbers = visible.data() + row * static_cast<std::size_t>(block.width);
        for (int column = 0; column < block.width; ++column) {
            std::int32_t& number = numbers[column];
            if (is_doubtful(number)) {
                DecisionLevel level = DecisionLevel::in_float;
                number = resolve({block.x + column, block.y + static_cast<int>(row)}, level);
                (level == DecisionLevel::exactly ? exactly : in_double) += 1;
            } else if (number >= 0 && renumber) {
                number = drawn_.numbers[static_cast<std::size_t>(number)];
            }
        }
        all_in_double += in_double;
        all_exactly += exactly;
    });
    const auto pixels = static_cast<std::int64_t>(visible.size());
    return {pixels - all_in_double - all_exactly, all_in_double, all_exactly};
}

void Resolver::accept_guesses(std::span<std::int32_t> visible) const {
    for (std::int32_t& number : visible) {
        if (is_doubtful(number)) number = doubtful(number);
        if (number >= 0) number = drawn_.number(static_cast<std::size_t>(number));
    }
}

}  // namespace sphereview

#include "light/explain_light.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <mutex>

#include "base/parallel.hpp"
#include "base/text.hpp"
#include "light/asked_point.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr std::size_t tried_at_once = 16384;
constexpr std::size_t most_blockers = 3;

// What is asked of one pixel again and again.
class Shadows {
public:
    explicit Shadows(const LitPixel& pixel)
        : pixel_(pixel),
          sphere_(sphere(pixel.visible)),
          side_(pixel.drawn.side(*pixel.drawn.index_of(static_cast<std::uint32_t>(pixel.visible)))),
          point_(pixel.camera, pixel.size, pixel.pixel, sphere_, side_),
          places_(pixel.camera, pixel.size) {}

    const ExactLitPoint& point() const { return point_; }
    const Sphere& sphere(std::int32_t number) const { return pixel_.scene.spheres[static_cast<std::size_t>(number)]; }

    // The spheres that keep a light away, ascending.
    std::vector<std::int32_t> blockers(const glm::dvec3& direction) const {
        const DrawnSpheres& drawn = pixel_.drawn;
        std::vector<std::int32_t> found;
        std::mutex joining;
        parallel_pieces(drawn.size(), tried_at_once, [&](std::size_t begin, std::size_t end) {
            std::vector<std::int32_t> part;
            AskedPoint point(places_, pixel_.pixel, sphere_, side_);
            for (std::size_t i = begin; i < end; ++i) {
                if (std::ranges::binary_search(drawn.gone, static_cast<std::uint32_t>(i))) continue;
                const std::int32_t number = drawn.number(i);
                if (number == pixel_.visible || drawn.side(i) != EyeSide::outside) continue;
                if (point.blocked(sphere(number), direction)) part.push_back(number);
            }
            const std::lock_guard lock(joining);
            found.insert(found.end(), part.begin(), part.end());
        });
        std::ranges::sort(found);
        return found;
    }

private:
    const LitPixel& pixel_;
    const Sphere& sphere_;
    EyeSide side_;
    ExactLitPoint point_;
    HitPlaces places_;
};

std::string counted(int count, const std::string& what) { return std::to_string(count) + " " + what + (count == 1 ? "" : "s"); }

}  // namespace

NumberedLights::NumberedLights(const Light& light, std::size_t spheres, const Camera& camera)
    : lights_(light_set(light, sky_lights(light, spheres, 1), camera, 0)),
      first_(light.sun ? 0 : 1),
      key_(key_direction(camera_axes(camera))) {}

std::optional<int> NumberedLights::main() const {
    if (lights_.empty()) return std::nullopt;
    if (first_ == 0) return 0;
    const auto from_key = [this](const DirectedLight& light) { return -dot(unit(light.direction), key_); };
    return static_cast<int>(std::ranges::min_element(lights_, {}, from_key) - lights_.begin()) + first_;
}

std::string NumberedLights::numbers_in_words() const {
    std::vector<std::string> parts;
    if (first_ == 0) parts.emplace_back("0 (the sun)");
    if (!sky().empty()) parts.push_back("1 to " + std::to_string(sky().size()));
    return parts.empty() ? "a scene with a light" : joined(parts, " or ");
}

LightExplanation explain_light(const LitPixel& pixel, const glm::dvec3& direction) {
    const Shadows shadows(pixel);
    LightExplanation explanation;
    explanation.facing = shadows.point().facing(direction);
    if (explanation.facing <= 0) return explanation;
    const std::vector<std::int32_t> blockers = shadows.blockers(direction);
    if (blockers.empty()) return explanation;
    explanation.blocker = blockers.front();
    explanation.signs = shadows.point().blocking(shadows.sphere(blockers.front()), direction);
    return explanation;
}

ExplainedLight explain_light(const LitPixel& pixel, const NumberedLights& lights, int number) {
    const DirectedLight& light = lights.at(number);
    return {number, light, explain_light(pixel, light.direction)};
}

SkyExplanation explain_sky(const LitPixel& pixel, std::span<const DirectedLight> lights) {
    const Shadows shadows(pixel);
    SkyExplanation explanation;
    explanation.lights = static_cast<int>(lights.size());
    std::map<std::int32_t, int> kept_away;
    for (const DirectedLight& light : lights) {
        if (shadows.point().facing(light.direction) <= 0) {
            ++explanation.behind;
            continue;
        }
        const std::vector<std::int32_t> blockers = shadows.blockers(light.direction);
        ++(blockers.empty() ? explanation.shining : explanation.blocked);
        if (blockers.empty()) explanation.sum += light.share;
        for (const std::int32_t number : blockers) ++kept_away[number];
    }
    for (const auto& [number, count] : kept_away) explanation.blockers.push_back({number, count});
    std::ranges::stable_sort(explanation.blockers, std::ranges::greater{}, &SkyExplanation::Blocker::lights);
    if (explanation.blockers.size() > most_blockers) explanation.blockers.resize(most_blockers);
    return explanation;
}

PixelLights explain_lights(const LitPixel& pixel, const NumberedLights& lights, std::size_t most_lines) {
    PixelLights found;
    if (const std::optional<int> main = lights.main()) found.main = explain_light(pixel, lights, *main);
    const std::span<const DirectedLight> sky = lights.sky();
    if (!sky.empty() && pixel.drawn.size() <= most_lines / sky.size()) found.sky = explain_sky(pixel, sky);
    if (sky.empty() || found.sky) {
        LightVector& sum = found.sum.emplace();
        if (found.sky) sum += found.sky->sum;
        if (found.main && found.main->is_sun() && found.main->explanation.shines()) sum += found.main->light.share;
    }
    return found;
}

std::string in_words(const SkyExplanation& explanation) {
    std::string text = std::to_string(explanation.shining) + " of " + counted(explanation.lights, "light") +
                       (explanation.shining == 1 ? " shines; " : " shine; ") + std::to_string(explanation.behind) +
                       " behind the surface (n.L <= 0), " + std::to_string(explanation.blocked) + " in shadow";
    std::vector<std::string> blockers;
    for (const SkyExplanation::Blocker& blocker : explanation.blockers) {
        blockers.push_back("sphere " + std::to_string(blocker.number) + " (" + counted(blocker.lights, "light") + ")");
    }
    if (!blockers.empty()) text += ", most of all behind " + joined(blockers, ", ");
    return text;
}

std::string in_words(const LightExplanation& explanation) {
    if (explanation.facing < 0) return "does not shine: n.L < 0, the surface faces away";
    if (explanation.facing == 0) return "does not shine: n.L = 0, the light is in the surface's tangent plane";
    if (!explanation.blocker) return "shines: n.L > 0, and no sphere is in the way";
    const std::string disc = explanation.signs.disc == 0 ? "= 0: the line to the light touches the sphere"
                                                         : "> 0: the line to the light goes through the sphere";
    return "does not shine: n.L > 0, but sphere " + std::to_string(*explanation.blocker) +
           " is in the way. With m from its centre to the point, m.L < 0: the centre lies towards the light; (m.L)^2 - L.L (m.m - "
           "r^2) " +
           disc;
}

}  // namespace sphereview

#include "mistakes/wrong_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>
#include <unordered_map>

#include "base/memory.hpp"
#include "base/parallel.hpp"
#include "base/square_root.hpp"
#include "cpu/cpu_renderer.hpp"
#include "exact/explain.hpp"
#include "exact/resolve.hpp"
#include "tiles/build_lists.hpp"

namespace sphereview {

namespace {

using Numbers = std::vector<std::int32_t>;

// The camera whose rays go the other way.
Camera turned_about(Camera camera) {
    camera.center = camera.eye + (camera.eye - camera.center);
    if (camera.orthographic()) return camera;  // its rays begin where they did
    camera.right = -camera.right;
    camera.up = -camera.up;
    return camera;
}

// Doubles tell two numbers apart that differ by more than this part of what they were made of.
constexpr double double_tells = 1e-11;
// Float arithmetic without care does: some 16 roundings of 2^-24.
constexpr double float_tells = 0x1p-20;

// Spheres that are tried exactly for one wrong picture, some 20 microseconds each: all that need it, in scenes that people draw.
constexpr std::int64_t most_exact_work = 100'000;

// Spheres that are tried for every pixel, all together, where rays hit nearly all: about a second.
constexpr double most_tries = 2e8;

// A sphere, as the line of one pixel's ray meets it.
struct LineHit {
    std::int32_t number;
    double t1;
    double t2;
    double t;      // the root that counts
    bool inside;   // the eye is inside the sphere, or on it
    bool tangent;  // t1 = t2, exactly
    bool as_near_as_last;
};

// origin + t direction, for t above and below 0.
struct Line {
    glm::dvec3 origin;
    glm::dvec3 direction;
};

// A line and a sphere in double.
struct Meeting {
    double along;         // t of the point nearest to the centre
    double discriminant;  // r^2 less the square of the distance from the centre: of the sign of the quadratic's
    double scale;         // what those were made of
    double c;             // (O - C).(O - C) - r^2
};

Meeting meet(const Sphere& sphere, const Line& line) {
    const glm::dvec3 v = sphere.center - line.origin;
    const double along = glm::dot(v, line.direction) / glm::dot(line.direction, line.direction);
    const glm::dvec3 p = v - along * line.direction;
    const double v_square = glm::dot(v, v);
    const double r_square = sphere.radius * sphere.radius;
    return {along, r_square - glm::dot(p, p), v_square + r_square, v_square - r_square};
}

// The spheres that the picture of a camera may show, and the hits of its rays.
class View {
public:
    View(const Scene& scene, const Camera& camera, PictureSize size)
        : scene_(scene),
          camera_(camera),
          size_(size),
          drawn_(drawn_spheres(scene, camera)),
          lists_(build_lists(drawn_, camera, size, cpu_tile_costs)) {
        if (drawn_.twins.empty()) return;
        using Place = std::tuple<double, double, double, double>;
        const auto place_of = [&](std::int32_t number) {
            const Sphere& s = sphere(number);
            return Place{s.center.x, s.center.y, s.center.z, s.radius};
        };
        std::map<Place, std::vector<std::int32_t>> twins;
        for (const std::int32_t number : drawn_.twins) twins[place_of(number)].push_back(number);
        for (std::size_t i = 0; i < drawn_.size(); ++i) {
            const auto found = twins.find(place_of(drawn_.number(i)));
            if (found != twins.end()) twins_.emplace(drawn_.number(i), found->second);
        }
    }

    // What a right tracer sees.
    Numbers numbers() const {
        Numbers visible(static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height));
        const Block whole{0, 0, size_.width, size_.height};
        CpuRenderer(drawn_, lists_, camera_, size_).trace(whole, visible);
        Resolver(scene_, drawn_, camera_, size_, &lists_).certify(whole, visible);
        return visible;
    }

    // Calls each(number, sphere) for the spheres that the pixel's ray may hit.
    template <typename Each>
    void for_candidates(Pixel pixel, const Each& each) const {
        for (const TileLevel& level : lists_.levels) {
            for (const Candidate& candidate : lists_.at(level, pixel.x, pixel.y)) {
                if (ends_walk(candidate, farthest_hit)) break;
                const std::int32_t number = drawn_.number(candidate.index);
                each(number, sphere(number));
                const auto twins = twins_.find(number);
                if (twins == twins_.end()) continue;
                for (const std::int32_t twin : twins->second) each(twin, sphere(twin));
            }
        }
    }

    Line ray(Pixel pixel) const {
        const RayCoefficients coefficients = ray_coefficients(size_, pixel);
        const double m = size_.shorter_side();
        const glm::dvec3 across = static_cast<double>(coefficients.across) / m * camera_.right;
        const glm::dvec3 upward = static_cast<double>(coefficients.upward) / m * camera_.up;
        const glm::dvec3 ahead = camera_.center - camera_.eye;
        return camera_.orthographic() ? Line{camera_.eye + across + upward, ahead} : Line{camera_.eye, ahead + across + upward};
    }

    // The hits of a pixel in front of the eye, nearest first, of equal ones the first in the file first. What double cannot tell is
    // decided exactly while `exact_work`, a number of spheres, lasts.
    void find(Pixel pixel, std::vector<LineHit>& hits, std::int64_t& exact_work) const {
        hits.clear();
        std::int64_t tried = 0;
        const Line line = ray(pixel);
        bool sure = true;
        for_candidates(pixel, [&](std::int32_t number, const Sphere& sphere) {
            const Meeting meeting = meet(sphere, line);
            ++tried;
            const double doubt = double_tells * meeting.scale;
            sure = sure && std::fabs(meeting.discriminant) > doubt && std::fabs(meeting.c) > doubt;
            if (!(meeting.discriminant > 0.0)) return;
            const double half = square_root(meeting.discriminant / glm::dot(line.direction, line.direction));
            const double t1 = meeting.along - half;
            const double t2 = meeting.along + half;
            const bool inside = meeting.c < 0.0;
            if (inside || meeting.along > 0.0) hits.push_back({number, t1, t2, inside ? t2 : t1, inside, false, false});
        });
        std::ranges::sort(hits, {}, [](const LineHit& hit) { return std::pair(hit.t, hit.number); });
        for (std::size_t i = 1; i < hits.size() && hits[i].t - hits[0].t <= double_tells * std::fabs(hits[0].t); ++i) {
            hits[i].as_near_as_last = same_geometry(sphere(hits[i].number), sphere(hits[i - 1].number));
            sure = sure && hits[i].as_near_as_last;
        }
        if (sure || exact_work < tried) return;
        exact_work -= tried;
        find_exactly(pixel, hits);
    }

private:
    const Sphere& sphere(std::int32_t number) const { return scene_.spheres[static_cast<std::size_t>(number)]; }

    void find_exactly(Pixel pixel, std::vector<LineHit>& hits) const {
        hits.clear();
        for (const ExplainedHit& hit : explain_pixel(scene_, drawn_, camera_, size_, pixel, &lists_).hits) {
            hits.push_back(
                {hit.number, hit.t1, hit.t2, hit.t, hit.eye != EyeSide::outside, hit.discriminant_sign == 0, hit.as_near_as_last});
        }
    }

    const Scene& scene_;
    Camera camera_;
    PictureSize size_;
    DrawnSpheres drawn_;
    CandidateLists lists_;
    std::unordered_map<std::int32_t, std::vector<std::int32_t>> twins_{};  // of the first of each
};

void put_in_order(std::vector<LineHit>& hits) {
    std::ranges::stable_sort(hits, {}, &LineHit::t);
    for (std::size_t i = 1; i < hits.size(); ++i) hits[i].as_near_as_last = hits[i].t == hits[i - 1].t;
}

// What a person's program takes for hits, with the root that it takes, nearest first. `hits`: those in front of the eye. `behind`:
// what the ray's other half meets, with the signs of t changed.
void take_wrongly(const WrongTracer& tracer, std::vector<LineHit>& hits, const std::vector<LineHit>& behind) {
    for (const LineHit& hit : behind) {
        if (!hit.inside) hits.push_back({hit.number, -hit.t2, -hit.t1, -hit.t2, false, hit.tangent, false});
    }
    if (tracer.root == RootRule::inside_missed) std::erase_if(hits, [](const LineHit& hit) { return hit.inside; });
    if (tracer.discriminant == DiscriminantRule::tangent_missed) {
        std::erase_if(hits, [](const LineHit& hit) { return hit.tangent; });
    }
    const bool far = tracer.root == RootRule::far_root;
    if (!far && tracer.side == SideRule::in_front) return;  // in their exact order already
    for (LineHit& hit : hits) hit.t = far ? hit.t2 : hit.t1;
    put_in_order(hits);
}

// The same where the discriminant itself is wrong, of all spheres.
void find_without_four(const WrongTracer& tracer, const Scene& scene, const Line& line, std::vector<LineHit>& hits) {
    hits.clear();
    const double a = glm::dot(line.direction, line.direction);
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const Sphere& sphere = scene.spheres[i];
        if (sphere.hidden) continue;
        const glm::dvec3 v = sphere.center - line.origin;
        const double b = -2.0 * glm::dot(line.direction, v);
        const double discriminant = b * b - a * (glm::dot(v, v) - sphere.radius * sphere.radius);
        if (!(discriminant >= 0.0)) continue;
        const double root = square_root(discriminant);
        const double t1 = (-b - root) / (2.0 * a);
        const double t2 = (-b + root) / (2.0 * a);
        const bool takes_far = tracer.root == RootRule::far_root;
        const bool tries_far = tracer.root == RootRule::right && tracer.side == SideRule::in_front;
        const double t = takes_far || (tries_far && !(t1 > 0.0)) ? t2 : t1;
        if (t > 0.0 || tracer.side == SideRule::behind) {
            hits.push_back({static_cast<std::int32_t>(i), t1, t2, t, false, false, false});
        }
    }
    put_in_order(hits);
}

std::int32_t shown_by(HitRule rule, const std::vector<LineHit>& hits) {
    const auto number_of = [&](auto found) { return found == hits.end() ? visible_background : found->number; };
    switch (rule) {
        case HitRule::nearest: break;
        case HitRule::first_in_file: return number_of(std::ranges::min_element(hits, {}, &LineHit::number));
        case HitRule::last_in_file: return number_of(std::ranges::max_element(hits, {}, &LineHit::number));
        case HitRule::farthest: return number_of(std::ranges::max_element(hits, {}, &LineHit::t));
        case HitRule::last_of_equals: {
            std::size_t last = 0;
            while (last + 1 < hits.size() && hits[last + 1].as_near_as_last) ++last;
            return hits.empty() ? visible_background : hits[last].number;
        }
    }
    return hits.empty() ? visible_background : hits.front().number;
}

Numbers wrong_numbers(const Scene& scene, const Camera& camera, PictureSize size, const WrongTracer& tracer) {
    const View view(scene, camera, size);
    const bool sees_rightly = tracer.root == RootRule::right && tracer.side == SideRule::in_front &&
                              tracer.discriminant == DiscriminantRule::right && tracer.rule == HitRule::nearest;
    if (sees_rightly) return view.numbers();
    const bool tries_all = tracer.discriminant == DiscriminantRule::without_four;
    std::unique_ptr<View> back;
    if (tracer.side == SideRule::behind && !tries_all) back = std::make_unique<View>(scene, turned_about(camera), size);
    const auto width = static_cast<std::size_t>(size.width);
    Numbers numbers(width * static_cast<std::size_t>(size.height));
    parallel_for(static_cast<std::size_t>(size.height), [&](std::size_t row) {
        std::vector<LineHit> hits;
        std::vector<LineHit> behind;
        std::int64_t exact_work = std::max<std::int64_t>(most_exact_work / size.height, 64);
        for (std::size_t column = 0; column < width; ++column) {
            const Pixel pixel{static_cast<int>(column), static_cast<int>(row)};
            if (tries_all) {
                find_without_four(tracer, scene, view.ray(pixel), hits);
            } else {
                view.find(pixel, hits, exact_work);
                if (back != nullptr) back->find(pixel, behind, exact_work);
                take_wrongly(tracer, hits, behind);
            }
            numbers[row * width + column] = shown_by(tracer.rule, hits);
        }
    });
    return numbers;
}

// The scene with every sphere so much larger that it reaches all the rays of which float may take it to be hit.
Scene grown(const Scene& scene, PictureSize size) {
    Scene larger = scene;
    const double m = size.shorter_side();
    const glm::dvec3 reach = glm::abs(scene.camera.right) * (size.width / m) + glm::abs(scene.camera.up) * (size.height / m);
    for (Sphere& sphere : larger.spheres) {
        const glm::dvec3 v = glm::abs(sphere.center - scene.camera.eye) + reach;
        const double r_square = sphere.radius * sphere.radius;
        const double radius = square_root(r_square + 2.0 * float_tells * (glm::dot(v, v) + r_square));
        if (std::isfinite(radius)) sphere.radius = radius;
    }
    return larger;
}

}  // namespace

struct WrongPictures::FloatView {
    explicit FloatView(const Scene& scene, PictureSize size) : larger(grown(scene, size)), view(larger, scene.camera, size) {}

    Scene larger;
    View view;
};

WrongPictures::WrongPictures(const Scene& scene, PictureSize size) : scene_(scene), size_(size) {
    constexpr std::uint64_t bytes_a_pixel = 280;  // numbers of up to 65 tracers, and marks
    const auto pixels = static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
    require_memory(pixels * bytes_a_pixel, "what wrong tracers see of " + std::to_string(pixels) + " pixels needs");
}

WrongPictures::~WrongPictures() = default;

const std::vector<std::int32_t>& WrongPictures::numbers(const WrongTracer& tracer) {
    const auto [found, added] = numbers_.try_emplace(tracer);
    if (added) found->second = wrong_numbers(scene_, seen_wrongly(scene_.camera, tracer, size_), size_, tracer);
    return found->second;
}

bool WrongPictures::takes_too_long(const WrongTracer& tracer) const {
    const double pixels = static_cast<double>(size_.width) * size_.height;
    return tracer.discriminant == DiscriminantRule::without_four &&
           pixels * static_cast<double>(scene_.spheres.size()) > most_tries;
}

void WrongPictures::forget_combinations() {
    std::erase_if(numbers_, [](const auto& entry) { return mistakes_of(entry.first).size() > 1; });
}

std::vector<std::int32_t> WrongPictures::numbers_in_float(Pixel pixel) {
    if (float_view_ == nullptr) float_view_ = std::make_unique<FloatView>(scene_, size_);
    const View& view = float_view_->view;
    const Line line = view.ray(pixel);
    const double square = glm::dot(line.direction, line.direction);

    // The range of t for each sphere that float may take to be hit.
    struct Span {
        std::int32_t number;
        double low;
        double high;
    };
    std::vector<Span> spans;
    double nearest_sure = std::numeric_limits<double>::infinity();
    view.for_candidates(pixel, [&](std::int32_t number, const Sphere&) {
        const Meeting meeting = meet(scene_.spheres[static_cast<std::size_t>(number)], line);
        const double doubt = float_tells * meeting.scale;
        if (meeting.discriminant < -doubt) return;
        const double most = square_root((meeting.discriminant + doubt) / square);
        const double least = square_root(std::max(meeting.discriminant - doubt, 0.0) / square);
        const double roundings = float_tells * (std::fabs(meeting.along) + most);
        const bool perhaps_inside = meeting.c <= doubt;
        const bool perhaps_outside = meeting.c >= -doubt;
        const double low = (perhaps_outside ? meeting.along - most : meeting.along + least) - roundings;
        const double high = (perhaps_inside ? meeting.along + most : meeting.along - least) + roundings;
        if (high <= 0.0) return;
        spans.push_back({number, low, high});
        if (meeting.discriminant > doubt && low > 0.0) nearest_sure = std::min(nearest_sure, high);
    });
    std::vector<std::int32_t> numbers;
    for (const Span& span : spans) {
        if (span.low <= nearest_sure) numbers.push_back(span.number);
    }
    if (std::isinf(nearest_sure)) numbers.push_back(visible_background);
    return numbers;
}

}  // namespace sphereview

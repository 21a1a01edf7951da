#include "mistakes/wrong_tracer.hpp"

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

// The camera whose right picture is the wrong one of these mistakes. Its numbers are rounded once: a ray is off by some 1e-16 of
// the picture's size, far less than what tells two mistakes apart.
Camera seen_wrongly(Camera camera, const WrongTracer& tracer, PictureSize size) {
    if (tracer.orientation == Orientation::y_down || tracer.orientation == Orientation::turned) camera.up = -camera.up;
    if (tracer.orientation == Orientation::x_mirrored || tracer.orientation == Orientation::turned) camera.right = -camera.right;
    if (tracer.orientation == Orientation::swapped) std::tie(camera.right, camera.up) = std::pair(-camera.up, -camera.right);

    const glm::dvec3 half_column = camera.right / static_cast<double>(size.shorter_side());
    const glm::dvec3 half_row = camera.up / static_cast<double>(size.shorter_side());
    const auto move = [&camera](const glm::dvec3& way) {
        camera.center += way;
        if (camera.orthographic()) camera.eye += way;  // the direction stays
    };
    switch (tracer.place) {
        case RayPlace::center: break;
        case RayPlace::top_left: move(half_row - half_column); break;
        case RayPlace::top_right: move(half_row + half_column); break;
        case RayPlace::bottom_left: move(-half_row - half_column); break;
        case RayPlace::bottom_right: move(half_column - half_row); break;
        case RayPlace::edges:
            camera.right *= size.width / std::max(size.width - 1.0, 1.0);
            camera.up *= size.height / std::max(size.height - 1.0, 1.0);
            break;
        case RayPlace::stretched:
            camera.right *= static_cast<double>(size.shorter_side()) / size.width;
            camera.up *= static_cast<double>(size.shorter_side()) / size.height;
            break;
    }
    return camera;
}

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

// A sphere in front of the eye, as one pixel's ray meets it.
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

// Of the hits in front of the eye, and those behind it with the signs of their t changed.
std::int32_t shown_by(HitRule rule, const std::vector<LineHit>& hits, const std::vector<LineHit>& behind) {
    const auto number_of = [](const auto& list, auto found) { return found == list.end() ? visible_background : found->number; };
    const auto far_root = [](const LineHit& hit) { return hit.t2; };
    switch (rule) {
        case HitRule::nearest: break;
        case HitRule::far_root: return number_of(hits, std::ranges::min_element(hits, {}, far_root));
        case HitRule::behind:
            if (!behind.empty()) return number_of(behind, std::ranges::max_element(behind, {}, far_root));
            break;
        case HitRule::inside_missed: return number_of(hits, std::ranges::find(hits, false, &LineHit::inside));
        case HitRule::tangent_missed: return number_of(hits, std::ranges::find(hits, false, &LineHit::tangent));
        case HitRule::first_in_file: return number_of(hits, std::ranges::min_element(hits, {}, &LineHit::number));
        case HitRule::last_in_file: return number_of(hits, std::ranges::max_element(hits, {}, &LineHit::number));
        case HitRule::last_of_equals: {
            std::size_t last = 0;
            while (last + 1 < hits.size() && hits[last + 1].as_near_as_last) ++last;
            return hits.empty() ? visible_background : hits[last].number;
        }
        case HitRule::farthest: return number_of(hits, std::ranges::max_element(hits, {}, &LineHit::t));
    }
    return hits.empty() ? visible_background : hits.front().number;
}

Numbers wrong_numbers(const Scene& scene, const Camera& camera, PictureSize size, HitRule rule) {
    const View view(scene, camera, size);
    if (rule == HitRule::nearest) return view.numbers();
    std::unique_ptr<View> back;
    if (rule == HitRule::behind) back = std::make_unique<View>(scene, turned_about(camera), size);
    const auto width = static_cast<std::size_t>(size.width);
    Numbers numbers(width * static_cast<std::size_t>(size.height));
    parallel_for(static_cast<std::size_t>(size.height), [&](std::size_t row) {
        std::vector<LineHit> hits;
        std::vector<LineHit> behind;
        std::int64_t exact_work = std::max<std::int64_t>(most_exact_work / size.height, 64);
        for (std::size_t column = 0; column < width; ++column) {
            const Pixel pixel{static_cast<int>(column), static_cast<int>(row)};
            view.find(pixel, hits, exact_work);
            if (back != nullptr) back->find(pixel, behind, exact_work);
            numbers[row * width + column] = shown_by(rule, hits, behind);
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

std::vector<WrongTracer> with_one_more_mistake(const WrongTracer& tracer, PictureSize size) {
    std::vector<WrongTracer> more;
    const bool square = size.width == size.height;
    // Of two mistakes that look the same the first is named.
    for (std::size_t i = 1; tracer.rule == HitRule::nearest && i < hit_rule_words.size(); ++i) {
        more.push_back({tracer.orientation, tracer.place, static_cast<HitRule>(i)});
    }
    for (std::size_t i = 1; tracer.orientation == Orientation::right && i < orientation_words.size(); ++i) {
        if (static_cast<Orientation>(i) != Orientation::swapped || square) {
            more.push_back({static_cast<Orientation>(i), tracer.place, tracer.rule});
        }
    }
    for (std::size_t i = 1; tracer.place == RayPlace::center && i < ray_place_words.size(); ++i) {
        if (static_cast<RayPlace>(i) != RayPlace::stretched || !square) {
            more.push_back({tracer.orientation, static_cast<RayPlace>(i), tracer.rule});
        }
    }
    return more;
}

std::vector<MistakeWords> mistakes_of(const WrongTracer& tracer) {
    std::vector<MistakeWords> all = {orientation_words[static_cast<std::size_t>(tracer.orientation)],
                                     ray_place_words[static_cast<std::size_t>(tracer.place)],
                                     hit_rule_words[static_cast<std::size_t>(tracer.rule)]};
    std::erase_if(all, [](const MistakeWords& words) { return words.name.empty(); });
    return all;
}

struct WrongPictures::FloatView {
    explicit FloatView(const Scene& scene, PictureSize size) : larger(grown(scene, size)), view(larger, scene.camera, size) {}

    Scene larger;
    View view;
};

WrongPictures::WrongPictures(const Scene& scene, PictureSize size) : scene_(scene), size_(size) {
    constexpr std::uint64_t bytes_a_pixel = 200;  // numbers of up to 45 tracers, and marks
    const auto pixels = static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
    require_memory(pixels * bytes_a_pixel, "what wrong tracers see of " + std::to_string(pixels) + " pixels needs");
}

WrongPictures::~WrongPictures() = default;

const std::vector<std::int32_t>& WrongPictures::numbers(const WrongTracer& tracer) {
    const auto [found, added] = numbers_.try_emplace(tracer);
    if (added) found->second = wrong_numbers(scene_, seen_wrongly(scene_.camera, tracer, size_), size_, tracer.rule);
    return found->second;
}

void WrongPictures::forget_combinations() {
    std::erase_if(numbers_, [](const auto& entry) { return mistakes_of(entry.first).size() > 1; });
}

std::vector<std::int32_t> WrongPictures::numbers_in_float(Pixel pixel) {
    if (float_view_ == nullptr) float_view_ = std::make_unique<FloatView>(scene_, size_);
    const View& view = float_view_->view;
    const Line line = view.ray(pixel);
    const double square = glm::dot(line.direction, line.direction);

    // Of each sphere that float may take to be hit: between which t.
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

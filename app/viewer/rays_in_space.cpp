#include "viewer/rays_in_space.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "base/text.hpp"
#include "camera/beside.hpp"
#include "camera/navigation.hpp"
#include "cpu/cpu_renderer.hpp"
#include "exact/explain.hpp"
#include "exact/resolve.hpp"
#include "panels/math_text.hpp"
#include "scene/vectors.hpp"
#include "tiles/build_lists.hpp"
#include "viewer/hidden_parts.hpp"
#include "viewer/viewer_state.hpp"

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

namespace {

// How long a redraw waits for rays: those of few spheres move with what is dragged.
constexpr std::chrono::milliseconds patience_with_rays{8};
constexpr int probes = 12;                    // rows of rays that find out where the scene is
constexpr double beyond_hits = 1.2;           // where rays end that hit nothing, relative to the deepest hit
constexpr double beyond_screen = 3.0;         // and relative to the screen where nothing is hit
constexpr double dwarfs = 0.5;                // a sphere of such a part of its distance need not be seen as a whole
constexpr std::size_t most_looked_at = 2000;  // spheres
constexpr int coarsest = 4;                   // times as far between rays as is usual
constexpr int longest_picture = 720;          // pixels of the eye's picture, which is drawn no larger than that
constexpr int most_samples = 4;
constexpr int redraws_until_sized = 2;

PictureSize no_longer_than(PictureSize size, int longest) {
    const double factor = std::min(1.0, static_cast<double>(longest) / std::max(size.width, size.height));
    const auto side = [factor](int length) { return std::max(1, static_cast<int>(std::lround(factor * length))); };
    return {side(size.width), side(size.height)};
}

// What must be seen from beside: eye, screen, where rays end, and the spheres there, as far as they do not dwarf it all.
std::vector<glm::dvec3> points_beside(const ViewerState& state, const std::vector<TracedRay>& rays) {
    const RaysInSpace& shown = state.rays;
    std::vector<glm::dvec3> points = {shown.camera.eye};
    const std::vector<double> depths =
        shown.camera.orthographic() ? std::vector{0.0, shown.screen_depth} : std::vector{shown.screen_depth};
    for (const double depth : depths) {
        for (const glm::dvec3& corner : screen_corners(shown.camera, shown.size, depth)) points.push_back(corner);
    }
    const auto add = [&](const Sphere& sphere) {
        const glm::dvec3 way = sphere.center - shown.camera.eye;
        if (sphere.radius * sphere.radius > dwarfs * dwarfs * dot(way, way)) return;
        for (int axis = 0; axis < 3; ++axis) {
            for (const double side : {-sphere.radius, sphere.radius}) {
                glm::dvec3 pole = sphere.center;
                pole[axis] += side;
                points.push_back(pole);
            }
        }
    };
    double deepest = 0.0;
    for (const TracedRay& ray : rays) {
        if (ray.visible < 0) continue;
        points.push_back(ray.to);
        deepest = std::max(deepest, depth_of(shown.camera, ray.to));
        add(state.scene().spheres[static_cast<std::size_t>(ray.visible)]);
    }
    // Of few spheres those that the rays have missed, or that are behind others, too.
    if (state.scene().spheres.size() > most_looked_at) return points;
    for (const Sphere& sphere : state.scene().spheres) {
        const auto place = place_of(shown.camera, shown.size, sphere.center);
        const bool inside =
            place && place->x > 0.0 && place->y > 0.0 && place->x < shown.size.width && place->y < shown.size.height;
        if (!sphere.hidden && inside && depth_of(shown.camera, sphere.center) < 2.0 * deepest) add(sphere);
    }
    return points;
}

// The hit nearest to the picture's middle; the middle where nothing is hit.
PinnedPixel first_pixel(PictureSize size, const std::vector<TracedRay>& rays) {
    PinnedPixel found{{size.width / 2, size.height / 2}, size};
    double nearest = std::numeric_limits<double>::infinity();
    for (const TracedRay& ray : rays) {
        const double away = std::hypot(ray.pixel.x - 0.5 * size.width, ray.pixel.y - 0.5 * size.height);
        if (ray.visible < 0 || away >= nearest) continue;
        nearest = away;
        found.pixel = ray.pixel;
    }
    return found;
}

std::vector<Pixel> probed_pixels(PictureSize size) {
    std::vector<Pixel> pixels;
    const int columns = std::max(1, probes * size.width / size.shorter_side());
    const int rows = std::max(1, probes * size.height / size.shorter_side());
    for (int i = 0; i < std::min(columns * rows, 8 * probes * probes); ++i) {
        pixels.push_back({static_cast<int>((i % columns + 0.5) * size.width / columns),
                          static_cast<int>((static_cast<double>(i / columns) + 0.5) * size.height / rows)});
        pixels.back().y = std::min(pixels.back().y, size.height - 1);
    }
    return pixels;
}

const std::optional<PinnedPixel>& drawn_pixel(const ViewerState& state) {
    return state.pins.first ? state.pins.first : state.pins.last;
}

int row_of(const ViewerState& state) {
    const auto& pixel = drawn_pixel(state);
    const int height = state.rays.size.height;
    if (!pixel) return height / 2;
    return std::clamp(static_cast<int>(std::floor(place_in(state.rays.size, *pixel).y)), 0, height - 1);
}

AskedRays asked_rays(const ViewerState& state) {
    const RayChoice& choice = state.rays.choice;
    return {state.document.revision(), choice, choice.shown == RaysShown::row ? row_of(state) : 0};
}

AskedPicture asked_picture(const ViewerState& state) {
    PictureOptions options;
    options.camera = state.rays.camera;
    options.size = no_longer_than(state.rays.size, longest_picture);
    options.background = state.shown_background();
    options.samples = std::min(state.settings.samples, most_samples);
    options.shading = state.settings.shading;
    options.light = state.shown_light();
    return {state.document.revision(), options};
}

std::string light_in_words(const ViewerState& state, const InspectedLight& light) {
    const std::string name = light.is_sun() ? "sun" : "light nearest to the key light";
    if (light.shines) return "The " + name + " shines there: no sphere is in the way.";
    if (!light.blocker) return "The surface faces away from the " + name + ".";
    return title_of(state.scene(), *light.blocker) + " is in the way of the " + name + ".";
}

}  // namespace

void show_rays(ViewerState& state) {
    RaysInSpace& rays = state.rays;
    if (rays.on) return;
    const RayChoice choice = rays.choice;
    rays = {.on = true, .choice = choice, .camera = state.camera, .size = state.picture_size};
    rays.pivot = state.pivot;
    const std::vector<TracedRay> found = trace_rays(state.scene(), rays.camera, rays.size, probed_pixels(rays.size), 1.0);
    std::optional<double> nearest;
    double deepest = 0.0;
    for (const TracedRay& ray : found) {
        if (ray.visible < 0) continue;
        const double depth = depth_of(rays.camera, ray.to);
        nearest = std::min(nearest.value_or(depth), depth);
        deepest = std::max(deepest, depth);
    }
    rays.screen_depth = screen_depth_before(nearest);
    rays.far_depth = nearest ? std::max(beyond_hits * deepest, rays.screen_depth) : beyond_screen * rays.screen_depth;
    if (choice.in_row == 0) rays.choice.in_row = usual_every(rays.size, RaysShown::row);
    if (choice.in_picture == 0) rays.choice.in_picture = usual_every(rays.size, RaysShown::all);
    if (!state.pins.first && !state.pins.last) state.pins.last = first_pixel(rays.size, found);
    // The picture that is seen now, where it is finished, until another is asked for.
    if (rest_picture_is_shown(state)) rays.picture.set(asked_picture(state), state.rest_picture->image);
    const double middle = 0.5 * (rays.screen_depth + (nearest ? deepest : rays.far_depth));
    state.pivot = point_at(rays.camera, rays.size, {0.5 * rays.size.width, 0.5 * rays.size.height}, middle);
    state.flight.reset();
    rays.to_see = points_beside(state, found);
    rays.flies = true;
    rays.waits = redraws_until_sized;
}

void fly_beside(ViewerState& state, const glm::dvec2& covered) {
    RaysInSpace& rays = state.rays;
    if (!rays.flies && rays.beside && state.camera == *rays.beside && state.picture_size != rays.beside_size) {
        rays.flies = true;
        rays.waits = redraws_until_sized;
    }
    if (!rays.flies || rays.waits-- > 0) return;
    rays.flies = false;
    rays.beside = camera_beside(rays.camera, state.picture_size, rays.to_see, covered);
    rays.beside_size = state.picture_size;
    if (rays.beside) state.flight.emplace(state.camera, *rays.beside, state.pivot);
}

void end_rays(ViewerState& state) {
    RaysInSpace& rays = state.rays;
    if (!rays.on) return;
    const Camera camera = rays.camera;
    state.pivot = rays.pivot;
    rays = {.choice = rays.choice};
    state.flight.emplace(state.camera, camera, state.pivot);
}

void follow_rays(ViewerState& state) {
    RaysInSpace& rays = state.rays;
    if (!rays.on) return;
    rays.choice.in_row = std::max(rays.choice.in_row, least_every(rays.size, RaysShown::row));
    rays.choice.in_picture = std::max(rays.choice.in_picture, least_every(rays.size, RaysShown::all));
    take_rays(state);
    if (rays.choice.shown == RaysShown::one) {
        rays.rays = {};
    } else {
        rays.rays.ask(asked_rays(state), [&]() -> std::function<std::vector<TracedRay>(WorkControl&)> {
            return [scene = scene_snapshot(state), camera = rays.camera, size = rays.size, far = rays.far_depth,
                    pixels = pixels_of_rays(rays.size, rays.choice, row_of(state))](WorkControl&) {
                return trace_rays(*scene, camera, size, pixels, far);
            };
        });
        rays.rays.take(patience_with_rays);
    }
    const AskedPicture picture = asked_picture(state);
    rays.picture.ask(picture, [&]() -> std::function<Image(WorkControl&)> {
        return [scene = scene_snapshot(state), options = picture.options](WorkControl& control) {
            return render_beside(*scene, options, control);
        };
    });
}

bool take_rays(ViewerState& state) {
    const bool rays = state.rays.rays.take();
    const bool picture = state.rays.picture.take();
    return rays || picture;
}

bool makes_rays(const ViewerState& state) { return state.rays.rays.works() || state.rays.picture.works(); }

std::optional<PinnedPixel> eye_pixel_at(const ViewerState& state, const glm::dvec2& place, std::int32_t visible, bool on_screen) {
    const RaysInSpace& rays = state.rays;
    const auto screen = place_on_screen(rays.camera, rays.size, rays.screen_depth, state.camera, state.picture_size, place);
    const auto surface = has_sphere(state.scene(), visible) ? hit_depth(state.camera, state.picture_size, place,
                                                                        state.scene().spheres[static_cast<std::size_t>(visible)])
                                                            : std::nullopt;
    const auto pixel = [&](const glm::dvec2& at) {
        return PinnedPixel{{static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y))}, rays.size};
    };
    if (screen && (!surface || screen->depth < *surface)) return pixel(screen->place);
    if (!surface || on_screen) return std::nullopt;
    const auto at = place_of(rays.camera, rays.size, point_at(state.camera, state.picture_size, place, *surface));
    if (!at || !(at->x >= 0.0 && at->y >= 0.0 && at->x < rays.size.width && at->y < rays.size.height)) return std::nullopt;
    return pixel(*at);
}

RaysFacts facts_of_rays(const ViewerState& state, const std::optional<InspectedPixel>& first) {
    const RaysInSpace& rays = state.rays;
    RaysFacts facts;
    facts.size = rays.size;
    facts.pinned = state.pins.first.has_value();
    if (const auto& pixel = drawn_pixel(state)) facts.place = place_in(rays.size, *pixel);
    if (first && first->place.camera == rays.camera) {
        const PixelExplanation& e = first->explanation;
        const Pixel at = first->place.pixel;
        facts.meets = "Pixel " + std::to_string(at.x) + ", " + std::to_string(at.y) + ": ";
        const bool hit = has_sphere(state.scene(), e.visible());
        facts.meets +=
            hit ? title_of(state.scene(), e.visible()) + " at t = " + number_text(e.hits.front().t, 4) : "its ray hits nothing";
        if (hit && first->light) facts.light = light_in_words(state, *first->light);
    }
    if (rays.rays.made()) {
        facts.rays = rays.rays.made()->size();
        facts.hits = static_cast<std::size_t>(
            std::ranges::count_if(*rays.rays.made(), [](const TracedRay& ray) { return ray.visible >= 0; }));
    }
    facts.least_every = least_every(rays.size, rays.choice.shown);
    facts.most_every = std::max(coarsest * usual_every(rays.size, rays.choice.shown), facts.least_every);
    return facts;
}

}  // namespace sphereview

#include "viewer/pinned_pixels.hpp"

#include <memory>
#include <utility>

#include "app/failure.hpp"
#include "gpu/live_picture.hpp"
#include "tiles/build_lists.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

// The pointer need not wait for the sky's lights: some 20 milliseconds.
constexpr std::size_t most_lines_to_lights = 250'000;

// With more spheres, work on all of them cannot keep up with the pointer or a drag.
constexpr std::size_t most_spheres_on_the_way = 100'000;

// Each sphere that a ray hits is compared exactly, in some 20 microseconds: of more, nothing keeps up with the pointer.
constexpr std::size_t most_compared_at_once = 400;

// `explain_lights` explains them where the pixel shows that sphere.
void add_light(InspectedPixel& inspected, const Scene& scene, const auto& explain_lights) {
    const std::int32_t visible = inspected.explanation.visible();
    if (!inspected.place.light || visible < 0) return;
    const NumberedLights lights(*inspected.place.light, scene.spheres.size(), inspected.place.camera);
    const PixelLights found = explain_lights(visible, lights);
    if (found.main) {
        const auto& [number, directed, why] = *found.main;
        inspected.light = InspectedLight{number, directed.direction, why.shines(), in_words(why), why.blocker};
    }
    if (found.sky) inspected.sky = in_words(*found.sky);
    if (found.sum) {
        const PixelExplanation& e = inspected.explanation;
        inspected.color = explain_color(scene, inspected.place.camera, inspected.place.size, inspected.place.pixel, e.hits.front(),
                                        e.direction, *found.sum);
    }
}

std::size_t most_passed(const InspectedPlace& place) { return place.with_passed ? most_passed_explained : 0; }

// Without the picture that a window shows. `in_lists`: as if with its lists.
InspectedPixel inspected_alone(const Scene& scene, const InspectedPlace& place, bool in_lists) {
    const auto& [pixel, size, camera, revision, light, with_passed] = place;
    const DrawnSpheres drawn = drawn_spheres(scene, camera);
    std::optional<CandidateLists> lists;
    if (in_lists) lists = build_lists(drawn, camera, size, gpu_tile_costs);
    InspectedPixel inspected{place, explain_pixel(scene, drawn, camera, size, pixel, lists ? &*lists : nullptr, most_hits_explained,
                                                  most_passed(place))};
    add_light(inspected, scene, [&](std::int32_t visible, const NumberedLights& lights_on_it) {
        return explain_lights({scene, drawn, place.camera, place.size, place.pixel, visible}, lights_on_it, most_lines_to_lights);
    });
    return inspected;
}

// Explains the pixel, unless what is kept is of the same. Returns whether it did. `pinned`: it is worth some time.
bool explain(ViewerState& state, const LivePicture& picture, const PinnedPixel& pixel, bool pinned, PinnedPixels::Explained& beside,
             std::optional<InspectedPixel>& kept) {
    const std::optional<Light> light = is_lit(state.settings.shading) ? std::optional(state.shown_light()) : std::nullopt;
    const Scene& scene = state.scene();
    const bool with_passed = pinned || scene.spheres.size() <= most_spheres_on_the_way;
    const InspectedPlace place{pixel.pixel, pixel.size, state.inspected_camera(), state.document.revision(), light, with_passed};
    if (kept && kept->place == place) return false;
    const bool of_window = !state.rays.on && pixel.size == state.picture_size;
    if (!of_window && !with_passed) return false;
    // There are no lists for a pixel of another picture than the window's.
    const std::size_t most_compared = of_window ? picture.candidates(state.document, pixel.pixel) : scene.spheres.size();
    if (most_compared > most_compared_at_once) {
        using Make = PinnedPixels::Explained::Make;
        beside.ask(place, [&]() -> Make {
            return [place, of_window, spheres = scene_snapshot(state)](WorkControl&) {
                return inspected_alone(*spheres, place, of_window);
            };
        });
        beside.take();
        if (!beside.is_of(place)) return false;
        kept = *beside.made();
        return true;
    }
    if (!of_window) {
        kept = inspected_alone(scene, place, false);
        return true;
    }
    InspectedPixel inspected{place, picture.explain(state.document, pixel.pixel, most_passed(place))};
    add_light(inspected, scene, [&](std::int32_t visible, const NumberedLights& lights) {
        return picture.explain_lights(state.document, pixel.pixel, visible, lights, most_lines_to_lights);
    });
    kept = std::move(inspected);
    return true;
}

// Begins to write down what `sphereview explain` prints of the pixel for the scene saved with this view and light, and copies it
// once it is there, unless another is asked for before: of a million spheres that takes seconds.
void copy_explanation(ViewerState& state, const PinnedPixel& pixel) {
    const auto fail = [&state](const std::string& why) { report_error(state, "The arithmetic cannot be copied", why); };
    try {
        ExplainOptions options;
        options.pixel = pixel.pixel;
        options.size = pixel.size;
        options.background = state.background;
        options.shading = state.settings.shading;
        Scene around;  // the spheres: without them
        around.camera = state.inspected_camera();
        around.light = state.shown_light();
        around.background = state.scene().background;
        around.names = state.scene().names;
        const auto words = std::make_shared<std::string>();
        BackgroundJob job([words, options, scene = std::move(around), name = state.name(),
                           spheres = scene_snapshot(state)](WorkControl&) mutable {
            scene.spheres = spheres->spheres;
            spheres.reset();
            *words = explain(scene, name, options);
        });
        const auto done = [&state, words, at = pixel.pixel] {
            state.clipboard.set_text(*words);
            announce(state, "Copied the arithmetic of pixel " + std::to_string(at.x) + ", " + std::to_string(at.y));
        };
        state.copying.emplace(Work{.path = "", .job = std::move(job), .done = done, .fail = fail});
    } catch (...) {
        fail(describe_current_exception().message);
    }
}

}  // namespace

std::size_t inspect(ViewerState& state, const LivePicture& picture, const std::optional<PinnedPixel>& under_pointer, bool moves,
                    Inspection& inspection) {
    PinnedPixels& pins = state.pins;
    if (!state.has_pins()) {
        inspection = {};
        pins = {};
        return 0;
    }
    if (under_pointer) pins.last = under_pointer;
    inspection.pinned = pins.first.has_value();
    inspection.second_is_next = pins.second_is_next;
    if ((moves || picture.step() > 1) && state.scene().spheres.size() > most_spheres_on_the_way) return 0;
    std::size_t explained = 0;
    const auto follow = [&](const std::optional<PinnedPixel>& pixel, bool pinned, PinnedPixels::Explained& beside,
                            std::optional<InspectedPixel>& kept) {
        if (!pixel) {
            kept.reset();
        } else if (explain(state, picture, *pixel, pinned, beside, kept)) {
            ++explained;
        }
    };
    follow(pins.first ? pins.first : pins.last, pins.first.has_value(), pins.explained_first, inspection.first);
    follow(pins.second, true, pins.explained_second, inspection.second);
    return explained;
}

bool explains_beside(const ViewerState& state) { return state.pins.explained_first.works() || state.pins.explained_second.works(); }

bool take_explained(ViewerState& state) {
    const bool first = state.pins.explained_first.take();
    const bool second = state.pins.explained_second.take();
    return first || second;
}

void pin(PinnedPixels& pins, const PinnedPixel& pixel, bool beside) {
    if (pins.first && (beside || pins.second_is_next)) {
        pins.second = pixel;
    } else {
        pins.first = pixel;
    }
    pins.second_is_next = false;
}

bool let_go(PinnedPixels& pins) {
    const bool any = pins.first.has_value();
    if (pins.second_is_next) {
        pins.second_is_next = false;
    } else if (pins.second) {
        pins.second.reset();
    } else {
        pins.first.reset();
    }
    return any;
}

glm::dvec2 place_in(PictureSize size, const PinnedPixel& pixel) {
    const RayCoefficients ray = ray_coefficients(pixel.size, pixel.pixel);
    const double unit = static_cast<double>(size.shorter_side()) / pixel.size.shorter_side();
    return {0.5 * (size.width + unit * static_cast<double>(ray.across)),
            0.5 * (size.height - unit * static_cast<double>(ray.upward))};
}

void grant(ViewerState& state, InspectorWish wish) {
    PinnedPixels& pins = state.pins;
    const std::optional<PinnedPixel>& shown = pins.first ? pins.first : pins.last;
    const auto copy = [&](const std::optional<PinnedPixel>& pixel) {
        if (pixel) copy_explanation(state, *pixel);
    };
    switch (wish) {
        case InspectorWish::pin:
            if (pins.last) pin(pins, *pins.last, false);
            break;
        case InspectorWish::unpin:
            pins.first.reset();
            pins.second.reset();
            pins.second_is_next = false;
            break;
        case InspectorWish::compare: pins.second_is_next = pins.first.has_value(); break;
        case InspectorWish::copy: copy(shown); break;
        case InspectorWish::copy_second: copy(pins.second); break;
    }
}

}  // namespace sphereview

#include "viewer/pinned_pixels.hpp"

#include <memory>
#include <utility>

#include "app/failure.hpp"
#include "gpu/live_picture.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

// The pointer need not wait for the sky's lights: some 20 milliseconds.
constexpr std::size_t most_lines_to_lights = 250'000;

// Of more spheres, nothing that goes through all of them keeps up with the pointer or a drag.
constexpr std::size_t most_spheres_on_the_way = 100'000;

// Explains the pixel, unless what is kept is of the same. Returns whether it did. `pinned`: it is worth some time.
bool explain(const ViewerState& state, const LivePicture& picture, const PinnedPixel& pixel, bool pinned,
             std::optional<InspectedPixel>& kept) {
    const std::optional<Light> light =
        state.settings.shading == Shading::studio ? std::optional(state.shown_light()) : std::nullopt;
    const Camera& camera = state.inspected_camera();
    const Scene& scene = state.scene();
    const bool with_passed = pinned || scene.spheres.size() <= most_spheres_on_the_way;
    const InspectedPlace place{pixel.pixel, pixel.size, camera, state.document.revision(), light, with_passed};
    if (kept && kept->place == place) return false;
    const bool of_window = !state.rays.on && pixel.size == state.picture_size;
    if (!of_window && !with_passed) return false;
    const std::size_t most_passed = with_passed ? most_passed_explained : 0;
    // Of a pixel of another picture than the window's there are no lists.
    std::optional<DrawnSpheres> drawn;
    if (!of_window) drawn = drawn_spheres(scene, camera);
    InspectedPixel inspected{place, of_window ? picture.explain(state.document, pixel.pixel, most_passed)
                                              : explain_pixel(scene, *drawn, camera, pixel.size, pixel.pixel, nullptr,
                                                              most_hits_explained, most_passed)};
    const std::int32_t visible = inspected.explanation.visible();
    if (light && visible >= 0) {
        const NumberedLights lights(*light, scene.spheres.size(), camera);
        const PixelLights found =
            of_window ? picture.explain_lights(state.document, pixel.pixel, visible, lights, most_lines_to_lights)
                      : explain_lights({scene, *drawn, camera, pixel.size, pixel.pixel, visible}, lights, most_lines_to_lights);
        if (found.main) {
            const auto& [number, directed, why] = *found.main;
            inspected.light = InspectedLight{number, directed.direction, why.shines(), in_words(why), why.blocker};
        }
        if (found.sky) inspected.sky = in_words(*found.sky);
    }
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
    const auto follow = [&](const std::optional<PinnedPixel>& pixel, bool pinned, std::optional<InspectedPixel>& kept) {
        if (!pixel) {
            kept.reset();
        } else if (explain(state, picture, *pixel, pinned, kept)) {
            ++explained;
        }
    };
    follow(pins.first ? pins.first : pins.last, pins.first.has_value(), inspection.first);
    follow(pins.second, true, inspection.second);
    return explained;
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

#include "viewer/pinned_pixels.hpp"

#include "viewer/viewer_state.hpp"

namespace sphereview {

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
        if (!pixel) return;
        state.clipboard.set_text(explanation_in_words(state, *pixel));
        announce(state, "Copied the arithmetic of pixel " + std::to_string(pixel->pixel.x) + ", " + std::to_string(pixel->pixel.y));
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

std::string explanation_in_words(const ViewerState& state, const PinnedPixel& pixel) {
    Scene scene = state.scene();
    scene.camera = state.camera;
    ExplainOptions options;
    options.pixel = pixel.pixel;
    options.size = pixel.size;
    options.background = state.background;
    options.shading = state.settings.shading;
    options.light = state.light;
    return explain(scene, state.name(), options);
}

}  // namespace sphereview

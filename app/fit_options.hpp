// From where a scene is seen, if not by its own camera.
#pragma once

#include <optional>

#include "camera/fit.hpp"

namespace sphereview {

struct FitOptions {
    std::optional<bool> wanted{};    // to everything; none: only if nobody has chosen the scene's camera
    std::optional<ViewAxes> view{};  // none: the way that the scene's camera looks
};

}  // namespace sphereview

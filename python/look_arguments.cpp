#include "python/look_arguments.hpp"

#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "python/errors.hpp"

namespace sphereview {

namespace {

void require_above_0(const char* name, const std::optional<double>& value) {
    if (value && !(*value > 0.0 && std::isfinite(*value))) wrong_argument(name, shortest(*value), "a number above 0");
}

[[noreturn]] void only_with(const char* name, const char* other) {
    throw InputError(std::string(name) + ": expected " + other + " as well");
}

ValueRange range_from(const std::pair<double, double>& ends, bool log) {
    const auto [low, high] = ends;
    const std::string found = "(" + shortest(low) + ", " + shortest(high) + ")";
    if (!std::isfinite(low) || !std::isfinite(high) || low == high) wrong_argument("range", found, "(a, b), two different numbers");
    if (log && !(low > 0.0 && high > 0.0)) wrong_argument("range", found, "numbers above 0 with log");
    return {low, high};
}

}  // namespace

LookOptions look_from(const LookArguments& arguments) {
    const auto& [color_by, map, range, log, size_by, scale, radii, radius_scale] = arguments;
    if (!color_by && map) only_with("colormap", "color_by");
    if (!color_by && range) only_with("range", "color_by");
    if (!color_by && log) only_with("log", "color_by");
    if (!size_by && scale) only_with("scale", "size_by");
    if (size_by && radii) throw InputError("radii: expected no size_by beside it");
    LookOptions look;
    look.color_by = color_by;
    look.log = log;
    look.size_by = size_by;
    if (map) {
        look.map = color_map_named(*map);
        if (!look.map) wrong_argument("colormap", *map, color_map_syntax());
    }
    if (range) look.range = range_from(*range, log);
    require_above_0("scale", scale);
    look.scale = scale;
    if (radii) {
        look.radii = radii_named(*radii);
        if (!look.radii) {
            wrong_argument("radii", *radii, listed(std::vector<std::string>(radii_names.begin(), radii_names.end()), "or"));
        }
    }
    require_above_0("radius_scale", radius_scale);
    look.radius_scale = radius_scale;
    return look;
}

}  // namespace sphereview

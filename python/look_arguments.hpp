// Colours and sizes by what a file holds, as Python passes them.
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "app/look.hpp"

namespace sphereview {

// color_by, colormap, range, log, size_by, scale, radii and radius_scale; none where nothing is said.
using LookArguments =
    std::tuple<std::optional<std::string>, std::optional<std::string>, std::optional<std::pair<double, double>>, bool,
               std::optional<std::string>, std::optional<double>, std::optional<std::string>, std::optional<double>>;

// Throws InputError for what is out of its range, and for what says more of something that is not asked for.
LookOptions look_from(const LookArguments& arguments);

}  // namespace sphereview

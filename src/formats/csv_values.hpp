// What the fields of tables hold, as programs write it.
#pragma once

#include <optional>
#include <string_view>

#include "base/number.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

// What stands in a field that holds nothing: nothing, or what programs write for it ("nan", "NA", "#N/A").
bool is_missing(std::string_view text);

// A number as tables have them; `decimal_commas`: 1,5 is one.
NumberFault parse_csv_number(std::string_view text, bool decimal_commas, double& value);

// "#ff8000", "ff8000", "0xff8000" or "#f80", in any letter case; what stands for alpha behind it is passed over.
std::optional<Color> parse_hex_color(std::string_view text);

}  // namespace sphereview

// Text from outside, made fit for ImGui.
#pragma once

#include <string>
#include <string_view>

namespace sphereview {

// On one line: control characters, such as a line's end in a file's name, become spaces.
std::string on_one_line(std::string_view text);

// For a label, in which ImGui takes "##" for the end of what is shown.
std::string as_label(std::string_view text);

}  // namespace sphereview

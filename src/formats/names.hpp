// Names from files of any encoding.
#pragma once

#include <string>
#include <string_view>

namespace sphereview {

// `bytes` with each that is no part of a UTF-8 sequence replaced by U+FFFD: names must be UTF-8.
std::string as_utf8(std::string_view bytes);

}  // namespace sphereview

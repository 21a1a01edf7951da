// SHA-256, by the system's library: libmd, on macOS CommonCrypto, on Windows BCrypt.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace sphereview {

// In 64 hexadecimal digits, lower case. Throws RenderError where the system's library fails.
std::string sha256(std::string_view bytes);

// Of all pieces, one behind the other; next() gives an empty one at the end.
std::string sha256(const std::function<std::string_view()>& next);

}  // namespace sphereview

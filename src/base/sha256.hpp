// SHA-256, by the system's library: libmd, on macOS CommonCrypto, on Windows BCrypt.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace sphereview {

// The sum as 64 hexadecimal digits in lower case. Throws RenderError if the library fails.
std::string sha256(std::string_view bytes);

// The sum of all pieces together; next() gives an empty one at the end.
std::string sha256(const std::function<std::string_view()>& next);

}  // namespace sphereview

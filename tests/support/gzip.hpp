// Packing with zlib.
#pragma once

#include <string>
#include <string_view>

namespace sphereview::test {

// `text` as one gzip member.
std::string gzipped(std::string_view text);

}  // namespace sphereview::test

// The text format: N, then for each sphere `R G B`, `x y z`, `radius`, separated by white space and line ends of any kind.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// Told, now and then, that the first `bytes` of a text will not be looked at again.
using Consumed = std::function<void(std::size_t bytes)>;

// A piece of a file: what messages call the file, and where in it the text begins.
struct TextSource {
    std::string name;
    std::string_view text;
    TextPosition origin{};
    Consumed consumed = {};
};

// Reads the spheres of a whole text. Memory grows with the text, not with the count it claims. A byte-order mark is
// skipped. Throws InputError "NAME:LINE:COLUMN: found ..., expected ...".
std::vector<Sphere> parse_text_spheres(const TextSource& source);

// The spheres, without those that are hidden, as text that parse_text_spheres reads back bit for bit.
std::string write_text_spheres(const std::vector<Sphere>& spheres);

}  // namespace sphereview

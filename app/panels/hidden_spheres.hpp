// How many spheres of a document are hidden, without looking at all of them after each edit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "edit/document.hpp"

namespace sphereview {

class HiddenSpheres {
public:
    std::size_t count(const Document& document);

private:
    std::uint64_t revision_ = 0;  // of what follows; 0: none yet
    std::vector<bool> hidden_;
    std::size_t count_ = 0;
};

}  // namespace sphereview

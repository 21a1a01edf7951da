// Which spheres the list shows.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview {

// Those whose name contains the filter, ignoring the case of ASCII letters, and those whose number, or title "sphere 12", begins
// with it; ascending. For a filter that is not empty.
std::vector<std::uint32_t> filtered(const Scene& scene, std::string_view filter);

// Which spheres the rows of a list stand for: `listed`, or without a filter all, which nobody has to write down.
class ListedSpheres {
public:
    ListedSpheres(const Scene& scene, bool all, const std::vector<std::uint32_t>& listed)
        : all_(all), count_(all ? scene.spheres.size() : listed.size()), listed_(listed) {}

    std::size_t size() const { return count_; }
    std::uint32_t operator[](std::size_t row) const { return all_ ? static_cast<std::uint32_t>(row) : listed_[row]; }
    std::optional<std::size_t> row_of(std::uint32_t number) const;
    // The numbers in rows first..last, both included, in either order.
    std::vector<std::uint32_t> between(std::size_t first, std::size_t last) const;

private:
    bool all_;
    std::size_t count_;
    const std::vector<std::uint32_t>& listed_;
};

}  // namespace sphereview

#include "oracle/difference.hpp"

#include "formats/sphere_data.hpp"

namespace sphereview::oracle {

std::string difference(const Trial& trial, const std::string& source, const std::vector<std::int32_t>& expected,
                       const std::vector<std::int32_t>& found) {
    if (expected == found) return "";
    if (expected.size() != found.size()) return trial.name + ": " + source + " has another size";
    std::size_t count = 0;
    std::size_t first = 0;
    for (std::size_t i = expected.size(); i-- > 0;) {
        if (expected[i] == found[i]) continue;
        first = i;
        ++count;
    }
    const auto width = static_cast<std::size_t>(trial.size.width);
    return trial.name + ": " + source + " differs from the oracle at " + std::to_string(count) + " of " +
           std::to_string(expected.size()) + " pixels of " + std::to_string(trial.size.width) + "x" +
           std::to_string(trial.size.height) + ", first at pixel " + std::to_string(first % width) + "," +
           std::to_string(first / width) + ": sphere " + std::to_string(found[first]) + " instead of " +
           std::to_string(expected[first]) + " (-1: none)\n" + write_toml(trial.scene);
}

}  // namespace sphereview::oracle

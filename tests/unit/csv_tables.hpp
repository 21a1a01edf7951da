// Tables in text, as tests read them.
#pragma once

#include <string>
#include <vector>

#include "formats/sphere_data.hpp"
#include "support/spheres.hpp"

namespace sphereview {

using Lines = std::vector<std::string>;

inline const Centers two_centers = {{1, 2, 3}, {4, 5, 6}};

inline SphereData table(const std::string& text, const DataOptions& options = {}) { return read_csv(text, "a.csv", options); }

inline std::vector<Sphere> spheres(const std::string& text, const DataOptions& options = {}) {
    return table(text, options).scene.spheres;
}

inline Centers centers(const std::string& text, const DataOptions& options = {}) { return centers_of(table(text, options).scene); }

// What is said of such columns, each in quotes.
inline Lines passed_over(const std::string& columns) {
    return {"a.csv: columns that are passed over: " + columns + "; --color-by and --size-by can use them"};
}

inline DataOptions with_columns(const std::string& choices) {
    DataOptions options;
    options.columns = parse_column_choices(choices).value();
    return options;
}

}  // namespace sphereview

// The box of a crystal or of a simulation, and places in it.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

namespace sphereview {

// Three edges from one corner. The numbers may be anything that a file says.
struct Cell {
    glm::dvec3 corner{0.0};
    glm::dvec3 a{0.0};
    glm::dvec3 b{0.0};
    glm::dvec3 c{0.0};

    // The place at these parts of the edges. The same double on every machine, by * and + in a fixed order.
    glm::dvec3 place(const glm::dvec3& parts) const;

    // Whether the edges lie along x, y and z.
    bool has_right_angles() const;

    // Below 0 for a left-handed cell.
    double volume() const;
};

// The cell with edges of these lengths, above 0, and these angles in degrees: a lies along x, b in the plane of x and y, as usual
// in crystallography. The same doubles on every machine. Nothing if no cell has such angles.
std::optional<Cell> cell_of(const glm::dvec3& lengths, double alpha, double beta, double gamma);

// Within a relative 2^-50, by + - * / in a fixed order. `x` > 0 and finite.
double cube_root(double x);

}  // namespace sphereview

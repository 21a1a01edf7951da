#include "formats/cell.hpp"

#include <cmath>

#include "base/sine_cosine.hpp"
#include "base/square_root.hpp"

namespace sphereview {

glm::dvec3 Cell::place(const glm::dvec3& parts) const {
    const auto along = [&](int axis) { return ((parts.x * a[axis] + parts.y * b[axis]) + parts.z * c[axis]) + corner[axis]; };
    return {along(0), along(1), along(2)};
}

bool Cell::has_right_angles() const { return a.y == 0.0 && a.z == 0.0 && b.x == 0.0 && b.z == 0.0 && c.x == 0.0 && c.y == 0.0; }

double Cell::volume() const {
    return (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z)) + a.z * (b.x * c.y - b.y * c.x);
}

std::optional<Cell> cell_of(const glm::dvec3& lengths, double alpha, double beta, double gamma) {
    for (const double angle : {alpha, beta, gamma}) {
        if (!(angle > 0.0 && angle < 180.0)) return std::nullopt;
    }
    const double cos_alpha = sine_cosine(alpha).cosine;
    const double cos_beta = sine_cosine(beta).cosine;
    const auto [sin_gamma, cos_gamma] = sine_cosine(gamma);
    const double y = (cos_alpha - cos_beta * cos_gamma) / sin_gamma;
    const double square = (1.0 - cos_beta * cos_beta) - y * y;
    // Rounded, a flat cell need not be quite flat.
    constexpr double flat = 1e-12;
    if (!(square > flat)) return std::nullopt;
    Cell cell;
    cell.a = {lengths.x, 0.0, 0.0};
    cell.b = {lengths.y * cos_gamma, lengths.y * sin_gamma, 0.0};
    cell.c = {lengths.z * cos_beta, lengths.z * y, lengths.z * square_root(square)};
    return cell;
}

double cube_root(double x) {
    // In [1, 8), times a power of 8, whose root is exact.
    const int thirds = static_cast<int>(std::floor(std::ilogb(x) / 3.0));
    const double part = std::ldexp(x, -3 * thirds);
    double root = 1.5;
    constexpr int steps = 8;  // of Newton's: from there 6 are enough
    for (int i = 0; i < steps; ++i) root -= (root * root * root - part) / (3.0 * (root * root));
    return std::ldexp(root, thirds);
}

}  // namespace sphereview

#include "support/averaged.hpp"

#include <array>
#include <cmath>

namespace sphereview::test {

Picture averaged(const Picture& points, int side) {
    Picture picture{points.width / side, points.height / side, points.channels, ""};
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            std::array<double, 3> color{};  // whole numbers, all of them
            double cover = 0.0;
            for (int i = 0; i < side * side; ++i) {
                const std::vector<int> point = points.at(x * side + i % side, y * side + i / side);
                const double alpha = point.size() == 4 ? point[3] : 255;
                for (std::size_t c = 0; c < 3; ++c) color[c] += alpha * point[c];
                cover += alpha;
            }
            const double alpha = std::floor(cover / (side * side) + 0.5);
            for (const double sum : color) {
                picture.bytes += static_cast<char>(alpha == 0.0 ? 0 : static_cast<int>(std::floor(sum / cover + 0.5)));
            }
            if (picture.channels == 4) picture.bytes += static_cast<char>(static_cast<int>(alpha));
        }
    }
    return picture;
}

}  // namespace sphereview::test

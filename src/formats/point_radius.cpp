#include "formats/point_radius.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <utility>

#include "base/number.hpp"
#include "base/parallel.hpp"

namespace sphereview {

namespace {

constexpr std::size_t most_samples = 500;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Equal cubes in rows, columns and layers. The outermost ones hold what lies beyond, too, so that some far points do not make all
// cubes too large.
class Grid {
public:
    // A grid of about `cells` cubes over the box from `low` to `high`.
    Grid(const glm::dvec3& low, const glm::dvec3& high, double cells) : low_(low) {
        const glm::dvec3 size = high - low;
        const double longest = std::max({size.x, size.y, size.z});
        double rows = 1.0;
        while (count_of(size, longest / rows) <= cells && rows < most_rows) rows = std::floor(1.25 * rows) + 1.0;
        side_ = longest / rows;
        unit_ = std::ldexp(1.0, std::ilogb(side_));
        rows_in_unit_ = 1.0 / side_;
        for (int axis = 0; axis < 3; ++axis) counts_[axis] = static_cast<std::int64_t>(row_count(size[axis], side_));
    }

    double side() const { return side_; }
    // The power of two below it: distances in this unit are as exact as others, and their squares are doubles.
    double unit() const { return unit_; }
    std::size_t cells() const { return static_cast<std::size_t>(counts_[0] * counts_[1] * counts_[2]); }
    bool is_one_cell() const { return cells() == 1; }

    std::array<std::int64_t, 3> place(const glm::dvec3& point) const {
        std::array<std::int64_t, 3> place{};
        for (int axis = 0; axis < 3; ++axis) {
            const double row = (point[axis] - low_[axis]) * rows_in_unit_;
            place[static_cast<std::size_t>(axis)] =
                static_cast<std::int64_t>(std::clamp(row, 0.0, static_cast<double>(counts_[axis] - 1)));
        }
        return place;
    }

    std::size_t cell(const std::array<std::int64_t, 3>& place) const {
        return static_cast<std::size_t>((place[2] * counts_[1] + place[1]) * counts_[0] + place[0]);
    }

    // Calls visit(cell) for the cell at `place` and those that touch it.
    template <typename Visit>
    void around(const std::array<std::int64_t, 3>& place, const Visit& visit) const {
        std::array<std::int64_t, 3> at{};
        for (at[2] = std::max<std::int64_t>(place[2] - 1, 0); at[2] < std::min(place[2] + 2, counts_[2]); ++at[2]) {
            for (at[1] = std::max<std::int64_t>(place[1] - 1, 0); at[1] < std::min(place[1] + 2, counts_[1]); ++at[1]) {
                for (at[0] = std::max<std::int64_t>(place[0] - 1, 0); at[0] < std::min(place[0] + 2, counts_[0]); ++at[0]) {
                    visit(cell(at));
                }
            }
        }
    }

private:
    static constexpr double most_rows = 1e6;

    static double row_count(double size, double side) { return std::max(1.0, std::min(std::ceil(size / side), most_rows + 1.0)); }
    static double count_of(const glm::dvec3& size, double side) {
        return row_count(size.x, side) * row_count(size.y, side) * row_count(size.z, side);
    }

    glm::dvec3 low_;
    double side_ = 0.0;
    double unit_ = 0.0;
    double rows_in_unit_ = 0.0;  // of the scene's length
    std::array<std::int64_t, 3> counts_{};
};

// A point whose nearest neighbour is searched for, and the square of the least distance so far, in the grid's unit.
struct Sample {
    glm::dvec3 point;
    double nearest = infinity;
};

// Compares each point with the samples whose cells it lies in or beside.
void look_around(const std::vector<Sphere>& points, const Grid& grid, std::vector<Sample>& samples) {
    // For each cell, the samples to compare with: a list of lists in two arrays.
    std::vector<std::uint32_t> begins(grid.cells() + 1);
    for (const Sample& sample : samples) grid.around(grid.place(sample.point), [&](std::size_t cell) { ++begins[cell + 1]; });
    for (std::size_t cell = 0; cell < grid.cells(); ++cell) begins[cell + 1] += begins[cell];
    std::vector<std::uint32_t> next(begins.begin(), begins.end() - 1);
    std::vector<std::uint32_t> lists(begins.back());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        grid.around(grid.place(samples[i].point), [&](std::size_t cell) { lists[next[cell]++] = static_cast<std::uint32_t>(i); });
    }
    const auto workers = static_cast<std::size_t>(worker_count());
    std::vector<std::vector<double>> nearest(workers, std::vector<double>(samples.size(), infinity));
    parallel_for(workers, [&](std::size_t worker) {
        std::vector<double>& own = nearest[worker];
        const std::size_t end = points.size() * (worker + 1) / workers;
        for (std::size_t i = points.size() * worker / workers; i < end; ++i) {
            const glm::dvec3& point = points[i].center;
            const std::size_t cell = grid.cell(grid.place(point));
            for (std::size_t entry = begins[cell]; entry < begins[cell + 1]; ++entry) {
                const std::uint32_t sample = lists[entry];
                const glm::dvec3& other = samples[sample].point;
                const double x = (point.x - other.x) / grid.unit();
                const double y = (point.y - other.y) / grid.unit();
                const double z = (point.z - other.z) / grid.unit();
                const double square = x * x + y * y + z * z;
                if (square > 0.0 && square < own[sample]) own[sample] = square;
            }
        }
    });
    for (std::size_t i = 0; i < samples.size(); ++i) {
        for (const std::vector<double>& own : nearest) samples[i].nearest = std::min(samples[i].nearest, own[i]);
    }
}

// The box of the samples, without the outermost of many.
std::pair<glm::dvec3, glm::dvec3> box_of(const std::vector<Sample>& samples) {
    glm::dvec3 low(0.0);
    glm::dvec3 high(0.0);
    std::vector<double> row(samples.size());
    for (int axis = 0; axis < 3; ++axis) {
        std::ranges::transform(samples, row.begin(), [axis](const Sample& sample) { return sample.point[axis]; });
        std::ranges::sort(row);
        const std::size_t outermost = row.size() / 50;
        low[axis] = row[outermost];
        high[axis] = row[row.size() - 1 - outermost];
        if (low[axis] < high[axis]) continue;
        low[axis] = row.front();
        high[axis] = row.back();
    }
    return {low, high};
}

}  // namespace

std::optional<double> radius_of_points(const std::vector<Sphere>& points) {
    const std::size_t count = std::min(points.size(), most_samples);
    std::vector<Sample> samples(count);
    for (std::size_t i = 0; i < count; ++i) samples[i].point = points[i * points.size() / count].center;
    if (samples.empty()) return std::nullopt;
    const auto [low, high] = box_of(samples);
    const glm::dvec3 size = high - low;
    const double longest = std::max({size.x, size.y, size.z});
    if (!(longest > 0.0) || !std::isfinite(longest)) return std::nullopt;

    std::vector<double> distances;
    // With some points in each cube nearly every sample finds its neighbour at once; others try larger cubes.
    constexpr double points_per_cell = 4.0;
    for (double cells = static_cast<double>(points.size()) / points_per_cell; !samples.empty(); cells /= 8.0) {
        const Grid grid(low, high, cells);
        if (!(grid.side() > 0.0)) return std::nullopt;
        look_around(points, grid, samples);
        std::erase_if(samples, [&](Sample& sample) {
            // What lies in no cell around is farther away than a cube's side.
            const double side = grid.side() / grid.unit();
            const bool found = sample.nearest <= side * side || grid.is_one_cell();
            if (found && std::isfinite(sample.nearest)) distances.push_back(std::sqrt(sample.nearest) * grid.unit());
            sample.nearest = infinity;
            return found;
        });
    }
    if (distances.empty()) return std::nullopt;
    const auto median = distances.begin() + static_cast<std::ptrdiff_t>((distances.size() - 1) / 2);
    std::nth_element(distances.begin(), median, distances.end());
    const double radius = 0.25 * *median;
    return radius > 0.0 && std::isfinite(radius) ? std::optional(radius) : std::nullopt;
}

void use_radius_of_points(SphereData& data, const std::string& name, const DataOptions& options) {
    if (options.radius) return;
    data.asks_for_radius = true;
    const std::optional<double> given = options.radius_of_points;
    const std::optional<double> radius = given ? given : radius_of_points(data.scene.spheres);
    if (!radius) return;
    for (Sphere& sphere : data.scene.spheres) sphere.radius = *radius;
    if (given) return;
    data.radius_of_points = radius;
    data.warnings.push_back(name + ": no radius in the file: all get " + decimal(*radius, std::chars_format::general, 4) +
                            ", a quarter of the median distance to the nearest neighbour; --radius gives another");
}

}  // namespace sphereview

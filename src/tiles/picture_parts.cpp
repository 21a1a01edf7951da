#include "tiles/picture_parts.hpp"

#include <algorithm>
#include <cassert>

namespace sphereview {

namespace {

constexpr double cost_of_its_own = 4.0;  // of a texel, in candidates

}  // namespace

PictureParts::PictureParts(const CandidateLists& lists, const PixelGrid& grid, const PixelRange& covered)
    : grid_(grid), covered_(covered), row_(covered.top), column_(covered.left) {
    for (int row = covered.top; row <= covered.bottom; ++row) cost_ += row_cost(lists, row);
}

// An estimate: each tile's list counts for an equal part of the row's texels.
double PictureParts::row_cost(const CandidateLists& lists, int row) const {
    double cost = cost_of_its_own * (covered_.right - covered_.left + 1);
    for (const TileLevel& level : lists.levels) {
        const auto across = static_cast<std::size_t>(level.across);
        const std::size_t tile = level.first + static_cast<std::size_t>(grid_.traced_row(row) >> level.shift) * across;
        const double candidates = lists.begins[tile + across] - lists.begins[tile];
        const double tile_side = static_cast<double>(1 << level.shift) / grid_.step;
        cost += candidates * std::min(tile_side, static_cast<double>(grid_.size().width));
    }
    return cost;
}

double PictureParts::texel_cost(const CandidateLists& lists, int column, int row) const {
    double cost = cost_of_its_own;
    for (const TileLevel& level : lists.levels) {
        cost += static_cast<double>(lists.at(level, grid_.traced_column(column), grid_.traced_row(row)).size());
    }
    return cost;
}

int PictureParts::rows_at(int row) const { return std::min(smallest_side - row % smallest_side, covered_.bottom - row + 1); }

PictureParts::Part PictureParts::take(const CandidateLists& lists, double most_cost) {
    assert(!ended());
    const auto cost_of_rows = [&](int row) {
        double cost = 0.0;
        for (int i = 0; i < rows_at(row); ++i) cost += row_cost(lists, row + i);
        return cost;
    };
    Part part{{column_, row_, 0, 0}, 0.0};
    if (const double first = cost_of_rows(row_); column_ == covered_.left && first <= most_cost) {
        // Whole rows.
        part.block.width = covered_.right - covered_.left + 1;
        double next = first;
        while (row_ <= covered_.bottom && part.cost + next <= most_cost) {
            part.cost += next;
            row_ += rows_at(row_);
            if (row_ <= covered_.bottom) next = cost_of_rows(row_);
        }
        part.block.height = row_ - part.block.y;
    } else {
        // A piece of some rows, which are taken for equals.
        part.block.height = rows_at(row_);
        while (column_ <= covered_.right) {
            const int end = std::min(column_ + smallest_side - column_ % smallest_side, covered_.right + 1);
            double cost = 0.0;
            for (int column = column_; column < end; ++column) cost += texel_cost(lists, column, row_) * part.block.height;
            if (part.block.width > 0 && part.cost + cost > most_cost) break;
            part.cost += cost;
            part.block.width += end - column_;
            column_ = end;
        }
        if (column_ > covered_.right) {
            column_ = covered_.left;
            row_ += part.block.height;
        }
    }
    taken_ = std::min(taken_ + part.cost, cost_);
    return part;
}

}  // namespace sphereview

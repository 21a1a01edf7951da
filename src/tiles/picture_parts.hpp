// Divides a picture into parts of about the same cost, which the lists tell before anything is traced. Where thousands of spheres
// overlap everywhere, a slow device takes half a minute for the picture, so a window draws it part by part and answers in between.
#pragma once

#include "exact/candidates.hpp"
#include "exact/visible.hpp"
#include "tiles/pixel_range.hpp"

namespace sphereview {

// Goes through the texels of a grid from the top left. A texel's cost is the number of candidates in its lists, some of which the
// walk may skip, and a constant.
class PictureParts {
public:
    PictureParts() = default;
    // `covered`: the texels to go through. The same lists must be given to take().
    PictureParts(const CandidateLists& lists, const PixelGrid& grid, const PixelRange& covered);

    struct Part {
        Block block;  // of texels
        double cost = 0.0;
    };

    // The next part, which costs at most `most_cost`, or is of the smallest size. Not when ended().
    Part take(const CandidateLists& lists, double most_cost);

    bool ended() const { return row_ > covered_.bottom || covered_.empty(); }
    // The cost of all parts, and of the parts that are not taken yet.
    double cost() const { return cost_; }
    double cost_left() const { return ended() ? 0.0 : cost_ - taken_; }

    // llvmpipe shades 4 x 4 pixels at once, at the cost of all for one of them.
    static constexpr int smallest_side = 4;

private:
    double row_cost(const CandidateLists& lists, int row) const;
    double texel_cost(const CandidateLists& lists, int column, int row) const;
    // The rows from `row` to the next one that is a multiple of the smallest side.
    int rows_at(int row) const;

    PixelGrid grid_;
    PixelRange covered_;
    int row_ = 0;     // of the next part
    int column_ = 0;  // of the next part: after the first one, in a row that is taken in pieces
    double cost_ = 0.0;
    double taken_ = 0.0;
};

}  // namespace sphereview

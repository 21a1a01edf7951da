#include "image/strokes.hpp"

#include <stb_easy_font.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

namespace sphereview {

namespace {

constexpr int points = 4;  // of a pixel, in a row and in a column
constexpr int all_points = points * points;

// The largest whole number whose square is not larger.
std::int64_t whole_root(std::int64_t square) {
    auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(square)));
    while (root * root > square) --root;
    while ((root + 1) * (root + 1) <= square) ++root;
    return root;
}

// Whether points lie on a stroke. (p - from) x (to - from) is the distance from the line times the line's length.
class Covering {
public:
    explicit Covering(const Stroke& stroke)
        : from_(stroke.from),
          along_x_(stroke.to.x - stroke.from.x),
          along_y_(stroke.to.y - stroke.from.y),
          radius_square_(std::int64_t{stroke.width / 2} * (stroke.width / 2)),
          length_square_(along_x_ * along_x_ + along_y_ * along_y_),
          farthest_(whole_root(radius_square_ * length_square_)) {}

    bool covers(std::int64_t x, std::int64_t y) const {
        const std::int64_t right = x - from_.x;
        const std::int64_t down = y - from_.y;
        const std::int64_t along = right * along_x_ + down * along_y_;
        if (along <= 0) return right * right + down * down <= radius_square_;
        if (along >= length_square_) {
            const std::int64_t beyond_x = right - along_x_;
            const std::int64_t beyond_y = down - along_y_;
            return beyond_x * beyond_x + beyond_y * beyond_y <= radius_square_;
        }
        return std::abs(right * along_y_ - down * along_x_) <= farthest_;
    }

private:
    StrokePlace from_;
    std::int64_t along_x_;
    std::int64_t along_y_;
    std::int64_t radius_square_;
    std::int64_t length_square_;
    std::int64_t farthest_;
};

void put(const std::array<std::uint8_t, 3>& color, int covered, std::uint8_t* pixel, int channels) {
    const int alpha = channels == 4 ? pixel[3] : 255;
    const int own = covered * 255;
    const int below = (all_points - covered) * alpha;
    const int sum = own + below;
    for (std::size_t i = 0; i < color.size(); ++i)
        pixel[i] = static_cast<std::uint8_t>((own * color[i] + below * pixel[i] + sum / 2) / sum);
    if (channels == 4) pixel[3] = static_cast<std::uint8_t>((sum + all_points / 2) / all_points);
}

void draw(const Stroke& stroke, Image& picture) {
    const int radius = stroke.width / 2;
    const auto first = [&](int a, int b) { return std::max((std::min(a, b) - radius) / stroke_unit - 1, 0); };
    const auto last = [&](int a, int b, int side) { return std::min((std::max(a, b) + radius) / stroke_unit + 1, side - 1); };
    const Covering covering(stroke);
    const int right = last(stroke.from.x, stroke.to.x, picture.width());
    const int bottom = last(stroke.from.y, stroke.to.y, picture.height());
    for (int y = first(stroke.from.y, stroke.to.y); y <= bottom; ++y) {
        for (int x = first(stroke.from.x, stroke.to.x); x <= right; ++x) {
            int covered = 0;
            for (int point = 0; point < all_points; ++point) {
                // The middles of a grid in the pixel.
                const auto at = [](int pixel, int of_grid) {
                    return std::int64_t{pixel} * stroke_unit + (2 * of_grid + 1) * stroke_unit / (2 * points);
                };
                covered += covering.covers(at(x, point % points), at(y, point / points)) ? 1 : 0;
            }
            if (covered > 0) put(stroke.color, covered, picture.at(x, y), picture.channels());
        }
    }
}

std::string printable(std::string_view text) {
    std::string found;
    std::ranges::copy_if(text, std::back_inserter(found), [](char c) { return c >= ' ' && c <= '~'; });
    return found;
}

// stb's letters are made of boxes, one unit thick.
struct Box {
    float left, top, right, bottom;
};

std::vector<Box> boxes_of(std::string text) {
    // The bytes of a corner: x, y and z, and a colour. No letter has more than 20 boxes.
    constexpr std::size_t corner = 16;
    std::vector<std::uint8_t> bytes(text.size() * 20 * 4 * corner + 4 * corner);
    const int boxes = stb_easy_font_print(0.0F, 0.0F, text.data(), nullptr, bytes.data(), static_cast<int>(bytes.size()));
    std::vector<Box> found(static_cast<std::size_t>(boxes));
    for (std::size_t i = 0; i < found.size(); ++i) {
        // The first corner is the upper left one, the third the lower right one.
        std::memcpy(&found[i].left, &bytes[4 * corner * i], 2 * sizeof(float));
        std::memcpy(&found[i].right, &bytes[4 * corner * i + 2 * corner], 2 * sizeof(float));
    }
    return found;
}

}  // namespace

void draw(std::span<const Stroke> strokes, Image& picture) {
    for (const Stroke& stroke : strokes) draw(stroke, picture);
}

std::vector<Stroke> strokes_of_text(std::string_view text, StrokePlace corner, int unit, int width,
                                    const std::array<std::uint8_t, 3>& color) {
    std::vector<Stroke> strokes;
    const auto place = [&](float x, float y) {
        return StrokePlace{corner.x + static_cast<int>(x * static_cast<float>(unit)),
                           corner.y + static_cast<int>(y * static_cast<float>(unit))};
    };
    // A line through the middle of each box, from end to end; ends that touch at a corner alone are joined.
    const std::vector<Box> boxes = boxes_of(printable(text));
    const auto ends_of = [](const Box& box) {
        return std::array<std::array<float, 2>, 2>{{{box.left + 0.5F, box.top + 0.5F}, {box.right - 0.5F, box.bottom - 0.5F}}};
    };
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const auto ends = ends_of(boxes[i]);
        strokes.push_back({place(ends[0][0], ends[0][1]), place(ends[1][0], ends[1][1]), width, color});
        for (std::size_t j = 0; j < i; ++j) {
            for (const auto& [x, y] : ends_of(boxes[j])) {
                for (const auto& [own_x, own_y] : ends) {
                    const bool touches = std::abs(x - own_x) == 1.0F && std::abs(y - own_y) == 1.0F;
                    if (touches) strokes.push_back({place(x, y), place(own_x, own_y), width, color});
                }
            }
        }
    }
    return strokes;
}

int width_of_strokes(std::string_view text, int unit) {
    float widest = 0.0F;
    for (const Box& box : boxes_of(printable(text))) widest = std::max(widest, box.right);
    return static_cast<int>(widest) * unit;
}

}  // namespace sphereview

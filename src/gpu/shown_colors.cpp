#include "gpu/shown_colors.hpp"

#include <utility>

namespace sphereview {

namespace {

constexpr std::size_t most_single_uploads = 4096;

// In a colour's place for alpha. Twin: shaders/marks.glsl.
constexpr std::uint8_t selected_alone = 255;
constexpr std::uint8_t selected_in_set = 128;

}  // namespace

void ShownColors::set(const Scene& scene, const DrawnSpheres& drawn, Shading shading) {
    colors_ = shown_colors(scene, drawn, shading);
    all_changed_ = true;
    changed_.clear();
    marked_.clear();
    marks_known_ = false;
}

void ShownColors::change(std::size_t index, const ShownColor& color) {
    if (colors_[index] == color) return;
    colors_[index] = color;
    if (!all_changed_) changed_.push_back(static_cast<std::uint32_t>(index));
}

void ShownColors::follow(const Scene& scene, const DrawnSpheres& drawn, Shading shading, std::span<const std::uint32_t> numbers,
                         bool order) {
    // False colours are those of numbers.
    if (order && shading == Shading::id) {
        set(scene, drawn, shading);
        return;
    }
    if (order) marks_known_ = false;
    for (std::size_t index = colors_.size(); index < drawn.size(); ++index) {
        colors_.push_back(shown_color(scene, drawn.number(index), shading));
        changed_.push_back(static_cast<std::uint32_t>(index));
    }
    for (const std::uint32_t number : numbers) {
        const auto index = drawn.index_of(number);
        if (!index) continue;
        ShownColor color = shown_color(scene, static_cast<std::int32_t>(number), shading);
        color[3] = colors_[*index][3];
        change(*index, color);
    }
}

void ShownColors::mark(const std::vector<std::uint32_t>& numbers, const DrawnSpheres& drawn) {
    if (are_marked(numbers)) return;
    const auto set_mark = [&](std::size_t index, std::uint8_t mark) {
        ShownColor color = colors_[index];
        color[3] = mark;
        change(index, color);
    };
    for (const std::uint32_t index : std::exchange(marked_, {})) set_mark(index, 0);
    const std::uint8_t selected = numbers.size() > most_outlined_alone ? selected_in_set : selected_alone;
    for (const std::uint32_t number : numbers) {
        const auto index = drawn.index_of(number);
        if (!index) continue;
        set_mark(*index, selected);
        marked_.push_back(static_cast<std::uint32_t>(*index));
    }
    marked_numbers_ = numbers;
    marks_known_ = true;
}

void ShownColors::upload(SceneTables& tables) {
    if (all_changed_ || changed_.size() > most_single_uploads) {
        tables.upload_colors(colors_);
    } else if (!changed_.empty()) {
        tables.update_colors(colors_, changed_);
    }
    all_changed_ = false;
    changed_ = {};
}

}  // namespace sphereview

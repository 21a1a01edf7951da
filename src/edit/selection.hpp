// The selected spheres of a scene, their common values, and spheres like them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/sphere.hpp"

namespace sphereview {

// A set of sphere numbers, with the one that was chosen last. Sorted and with a version, because a selection changes rarely and is
// asked often, for each row and outline.
class Selection {
public:
    // Ascending.
    const std::vector<std::uint32_t>& numbers() const { return numbers_; }
    bool contains(std::uint32_t number) const;
    bool empty() const { return numbers_.empty(); }
    std::size_t size() const { return numbers_.size(); }
    // The sphere whose values an editor shows: the one chosen last, or, if that was removed, the last of the others. Nothing only
    // for an empty set.
    std::optional<std::uint32_t> primary() const { return primary_; }

    // Never the same for two different sets, so it identifies what was made of a set. 0: the empty set.
    std::uint64_t version() const { return version_; }

    void clear();
    void set(std::vector<std::uint32_t> numbers);  // any order; the last one is chosen last
    void set_only(std::uint32_t number);
    void set_all(std::size_t count);  // 0..count - 1
    void toggle(std::uint32_t number);
    // Selects the numbers of 0..count - 1 that were not selected, and no others.
    void invert(std::size_t count);
    // Adds these ascending numbers; removes them if all were selected.
    void toggle_all(const std::vector<std::uint32_t>& numbers);
    // Drops numbers from `count` on.
    void keep_below(std::size_t count);

    bool operator==(const Selection& other) const {
        return version_ == other.version_ || (primary_ == other.primary_ && numbers_ == other.numbers_);
    }

private:
    void changed();
    void choose_last();

    std::vector<std::uint32_t> numbers_;
    std::optional<std::uint32_t> primary_;
    std::uint64_t version_ = 0;
};

// The numbers of a sphere that a slider changes.
enum class SphereValue { x, y, z, radius, red, green, blue };
inline constexpr std::size_t sphere_values = 7;

constexpr bool is_color(SphereValue value) { return value > SphereValue::radius; }

double value_of(const Sphere& sphere, SphereValue value);
// `number`: within the value's range; for a colour a whole number from 0 to color_max.
void set_value(Sphere& sphere, SphereValue value, double number);

struct SharedValues {
    struct Range {
        double low = 0.0;
        double high = 0.0;
    };

    std::size_t count = 0;
    std::array<Range, sphere_values> ranges{};  // of each SphereValue; low == high if all are the same
    std::optional<Color> color;                 // the common colour, if any
    std::size_t hidden = 0;                     // number of hidden spheres

    const Range& range(SphereValue value) const { return ranges[static_cast<std::size_t>(value)]; }
};

// The values of the spheres with these numbers, which must exist.
SharedValues shared_values(const std::vector<Sphere>& spheres, const std::vector<std::uint32_t>& numbers);

// All spheres with the colour of one of these; ascending.
std::vector<std::uint32_t> colored_like(const std::vector<Sphere>& spheres, const std::vector<std::uint32_t>& numbers);

// All hidden spheres; ascending.
std::vector<std::uint32_t> hidden_ones(const std::vector<Sphere>& spheres);

}  // namespace sphereview

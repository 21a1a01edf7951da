// Which spheres of a scene are selected.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace sphereview {

// A set of sphere numbers, with the one that was chosen last.
class Selection {
public:
    // Ascending.
    const std::vector<std::uint32_t>& numbers() const { return numbers_; }
    bool contains(std::uint32_t number) const;
    bool empty() const { return numbers_.empty(); }
    std::size_t size() const { return numbers_.size(); }
    // The one chosen last, or, when that was taken out, the last of the others: whose values an editor shows. Nothing only in
    // an empty set.
    std::optional<std::uint32_t> primary() const { return primary_; }

    void clear();
    void set(std::vector<std::uint32_t> numbers);  // any order; the last one is chosen last
    void set_only(std::uint32_t number);
    void toggle(std::uint32_t number);
    // Drops what a scene of so many spheres does not have.
    void keep_below(std::size_t count);

    bool operator==(const Selection&) const = default;

private:
    void choose_last();

    std::vector<std::uint32_t> numbers_;
    std::optional<std::uint32_t> primary_;
};

}  // namespace sphereview

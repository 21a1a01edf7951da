// The spheres that the list shows, and its scrolling.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edit/condition.hpp"
#include "panels/panel_context.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// Finds the spheres whose name contains the filter, in any case of ASCII letters, or whose number, or title "sphere 12", begins
// with it; or the spheres that fulfil a condition (edit/condition.hpp). Searches a part of the scene at a time, so that a million
// names delay no redraw. A search by names is valid for a names_revision(), one by a condition for a revision() of the document.
class FilterSearch {
public:
    // Names in one step, or eight times as many spheres without name: some milliseconds.
    static constexpr std::size_t usual_step = 32768;

    // Begins a search. The filter must not be empty. A wrong condition finds nothing and has a fault().
    void begin(const Scene& scene, std::string_view filter);
    // The scene's names and numbers, and for a condition the scene, must not have changed since begin().
    void go_on(const Scene& scene, std::size_t step = usual_step);
    void finish(const Scene& scene);

    bool done() const { return next_ == count_; }
    // The part of the scene that was searched, 0..1.
    double part() const { return count_ == 0 ? 1.0 : static_cast<double>(next_) / static_cast<double>(count_); }
    const std::string& filter() const { return filter_; }
    // The condition's fault in words; "" for none.
    const std::string& fault() const { return fault_; }
    // The properties that the condition compares, each once, and those of them that the scene lacks.
    const std::vector<std::string>& compared() const { return compared_; }
    const std::vector<std::string>& unknown() const { return unknown_; }
    // Whether the file has one of the unknown() properties.
    bool waits_for(std::span<const std::string> names_in_file) const;
    // The numbers found so far, ascending.
    const std::vector<std::uint32_t>& found() const { return found_; }

private:
    void begin_condition(const Scene& scene);
    bool fits(std::uint32_t number) const;
    bool fits(std::string_view name) const;

    std::string filter_;
    std::string wanted_;  // to be found in names
    std::optional<SphereTest> condition_;
    std::string fault_;
    std::vector<std::string> compared_;
    std::vector<std::string> unknown_;
    struct NumberRange {
        std::uint64_t first;
        std::uint64_t behind;
    };
    std::vector<NumberRange> numbers_;  // numbers that begin with the filter's digits
    bool unnamed_ = false;              // all spheres without a name
    std::size_t next_ = 0;              // the next number to test
    std::size_t count_ = 0;
    std::vector<std::uint32_t> found_;
};

// The spheres of a list's rows: `listed`, or all without a filter, which stores no numbers.
class ListedSpheres {
public:
    ListedSpheres(const Scene& scene, bool all, const std::vector<std::uint32_t>& listed)
        : all_(all), count_(all ? scene.spheres.size() : listed.size()), listed_(listed) {}

    std::size_t size() const { return count_; }
    std::uint32_t operator[](std::size_t row) const { return all_ ? static_cast<std::uint32_t>(row) : listed_[row]; }
    std::optional<std::size_t> row_of(std::uint32_t number) const;
    // The numbers in rows first..last, both included, in either order.
    std::vector<std::uint32_t> between(std::size_t first, std::size_t last) const;

private:
    bool all_;
    std::size_t count_;
    const std::vector<std::uint32_t>& listed_;
};

// Scrolls in rows, as a double. ImGui scrolls in float pixels, but a million rows are more than 2^24 pixels, where float cannot
// tell neighbours apart.
class ListScroll {
public:
    // Sets the number of rows, and of rows seen at a time, which need not be whole. show()'s row stays in sight when fewer are
    // seen, because the editor below grows with the selection.
    void set_size(std::size_t rows, double seen);

    // The number of rows above the seen ones, which need not be whole.
    double above() const { return above_; }
    double most() const;
    bool is_needed() const { return most() > 0.0; }

    void by(double rows) { to(above_ + rows); }
    void to(double above);  // at most most()
    // Scrolls the row into the middle unless it is seen already.
    void show(std::size_t row);

    // A scroll bar at a place in screen coordinates, for the mouse. Noted as "list scroll bar".
    void draw_bar(const PanelContext& context, float left, float top, float width, float height);

private:
    double rows_ = 0.0;
    double seen_ = 1.0;
    double above_ = 0.0;
    std::optional<std::size_t> shown_;
    float grabbed_ = 0.0F;  // from the thumb's top to the mouse
};

}  // namespace sphereview

#include "panels/listed_spheres.hpp"

#include <imgui.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "scene/property_names.hpp"

namespace sphereview {

namespace {

// The digits in "12", "#12", "sphere 12" and "re 12"; "" if the filter is none of those.
std::string_view digits_of(std::string_view filter) {
    const std::size_t begin = filter.find_last_not_of("0123456789") + 1;  // npos + 1 is 0
    const std::string_view before = filter.substr(0, begin);
    return before == "#" || std::string_view("sphere ").ends_with(before) ? filter.substr(begin) : "";
}

}  // namespace

void FilterSearch::begin(const Scene& scene, std::string_view filter) {
    *this = {};
    filter_ = filter;
    wanted_ = lower_case(trimmed(filter));
    count_ = scene.spheres.size();
    if (is_condition(wanted_)) return begin_condition(scene);
    unnamed_ = std::string_view("sphere").find(wanted_) != std::string_view::npos;  // as every unnamed sphere is titled
    const std::string_view digits = digits_of(wanted_);
    std::uint64_t first = 0;
    if (!parse_whole(digits, first) || (digits.front() == '0' && digits.size() > 1)) return;
    for (std::uint64_t behind = first + 1; first < count_; first *= 10, behind *= 10) {
        numbers_.push_back({first, behind});
        if (first == 0) break;
    }
}

void FilterSearch::begin_condition(const Scene& scene) {
    try {
        const Condition condition(filter_);
        for (const ValueComparison& comparison : condition.comparisons()) {
            if (std::ranges::find(compared_, comparison.name) != compared_.end()) continue;
            compared_.push_back(comparison.name);
            if (!can_compare(scene, comparison.name)) unknown_.push_back(comparison.name);
        }
        condition_.emplace(condition, scene);
    } catch (const InputError& error) {
        fault_ = error.what();
        next_ = count_;
    }
}

bool FilterSearch::waits_for(std::span<const std::string> names_in_file) const {
    return std::ranges::any_of(unknown_, [&](const std::string& name) {
        return std::ranges::any_of(names_in_file, [&](const std::string& one) { return likeness(name, one) != Likeness::none; });
    });
}

bool FilterSearch::fits(std::uint32_t number) const {
    return std::ranges::any_of(numbers_, [&](const NumberRange& range) { return range.first <= number && number < range.behind; });
}

bool FilterSearch::fits(std::string_view name) const {
    const auto same = [](char a, char b) { return ('A' <= a && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b; };
    return std::search(name.begin(), name.end(), wanted_.begin(), wanted_.end(), same) != name.end() || wanted_.empty();
}

void FilterSearch::go_on(const Scene& scene, std::size_t step) {
    constexpr std::size_t for_a_name = 8;  // times as long as without
    std::size_t work = 0;
    for (; condition_ && next_ < count_ && work < for_a_name * step; ++work) {
        const auto number = static_cast<std::uint32_t>(next_++);
        if ((*condition_)(number)) found_.push_back(number);
    }
    if (condition_) return;
    auto name = scene.names.lower_bound(static_cast<std::uint32_t>(next_));
    while (next_ < count_ && work < for_a_name * step) {
        if (!unnamed_ && numbers_.empty()) next_ = name == scene.names.end() ? count_ : std::min<std::size_t>(name->first, count_);
        if (next_ == count_) return;
        const auto number = static_cast<std::uint32_t>(next_++);
        const bool named = name != scene.names.end() && name->first == number;
        if (fits(number) || (named ? fits(name->second) : unnamed_)) found_.push_back(number);
        work += named ? for_a_name : 1;
        if (named) ++name;
    }
}

void FilterSearch::finish(const Scene& scene) {
    while (!done()) go_on(scene);
}

std::optional<std::size_t> ListedSpheres::row_of(std::uint32_t number) const {
    if (all_) return number < count_ ? std::optional<std::size_t>(number) : std::nullopt;
    const auto found = std::ranges::lower_bound(listed_, number);
    if (found == listed_.end() || *found != number) return std::nullopt;
    return static_cast<std::size_t>(found - listed_.begin());
}

std::vector<std::uint32_t> ListedSpheres::between(std::size_t first, std::size_t last) const {
    if (first > last) std::swap(first, last);
    std::vector<std::uint32_t> numbers;
    numbers.reserve(last - first + 1);
    for (std::size_t row = first; row <= last; ++row) numbers.push_back((*this)[row]);
    return numbers;
}

void ListScroll::set_size(std::size_t rows, double seen) {
    if (static_cast<double>(rows) != rows_) shown_.reset();
    rows_ = static_cast<double>(rows);
    seen_ = std::max(seen, 1.0);
    above_ = std::min(above_, most());
    if (shown_) show(*shown_);
}

double ListScroll::most() const { return std::max(rows_ - seen_, 0.0); }

void ListScroll::to(double above) {
    above_ = std::clamp(above, 0.0, most());
    shown_.reset();
}

void ListScroll::show(std::size_t row) {
    const auto at = static_cast<double>(row);
    if (at < above_ || at + 1.0 > above_ + seen_) to(at - 0.5 * (seen_ - 1.0));
    shown_ = row;
}

void ListScroll::draw_bar(const PanelContext& context, float left, float top, float width, float height) {
    const float shortest = std::min(2.0F * width, height);
    const float thumb = std::max(shortest, height * static_cast<float>(seen_ / std::max(rows_, seen_)));
    const float track = std::max(height - thumb, 1.0F);
    const auto thumb_top = [&] { return most() > 0.0 ? top + track * static_cast<float>(above_ / most()) : top; };
    ImGui::SetCursorScreenPos({left, top});
    ImGui::InvisibleButton("##scroll bar", {width, height});
    note_widget(context, "list scroll bar");
    const float mouse = ImGui::GetMousePos().y;
    if (ImGui::IsItemActivated()) {
        const float in_thumb = mouse - thumb_top();
        grabbed_ = in_thumb >= 0.0F && in_thumb <= thumb ? in_thumb : 0.5F * thumb;
    }
    const bool held = ImGui::IsItemActive();
    if (held) to(most() * std::clamp(static_cast<double>((mouse - grabbed_ - top) / track), 0.0, 1.0));
    const ImGuiCol color = held                     ? ImGuiCol_ScrollbarGrabActive
                           : ImGui::IsItemHovered() ? ImGuiCol_ScrollbarGrabHovered
                                                    : ImGuiCol_ScrollbarGrab;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float rounding = ImGui::GetStyle().ScrollbarRounding;
    list.AddRectFilled({left, top}, {left + width, top + height}, ImGui::GetColorU32(ImGuiCol_ScrollbarBg), rounding);
    list.AddRectFilled({left, thumb_top()}, {left + width, thumb_top() + thumb}, ImGui::GetColorU32(color), rounding);
}

}  // namespace sphereview

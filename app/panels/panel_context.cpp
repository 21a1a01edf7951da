#include "panels/panel_context.hpp"

#include <algorithm>
#include <utility>

#include "base/text.hpp"

namespace sphereview {

void note_rectangle(const PanelContext& context, const std::string& name, ImVec2 low, ImVec2 size) {
    if (context.rectangles != nullptr) (*context.rectangles)[name] = {low.x, low.y, low.x + size.x, low.y + size.y};
}

void note_widget(const PanelContext& context, const std::string& name) {
    note_rectangle(context, name, ImGui::GetItemRectMin(), ImGui::GetItemRectSize());
}

void note_window(const PanelContext& context, const std::string& name) {
    note_rectangle(context, name, ImGui::GetWindowPos(), ImGui::GetWindowSize());
}

std::string name_of(const Scene& scene, std::uint32_t number) {
    const auto name = scene.names.find(number);
    return name == scene.names.end() ? "" : name->second;
}

std::string title_of(const Scene& scene, std::int64_t number) {
    const std::string name = name_of(scene, static_cast<std::uint32_t>(number));
    return "sphere " + std::to_string(number) + (name.empty() ? "" : " '" + shown_text(name) + "'");
}

std::string title_of(const Scene& scene, const std::vector<std::uint32_t>& numbers) {
    return numbers.size() == 1 ? title_of(scene, numbers.front()) : counted(numbers.size(), "sphere");
}

EditScene hide_or_show(const Scene& scene, const std::vector<std::uint32_t>& numbers) {
    const bool hide = std::ranges::any_of(numbers, [&](std::uint32_t number) { return !scene.spheres[number].hidden; });
    ChangeSpheres change{numbers, {}};
    change.spheres.reserve(numbers.size());
    for (const std::uint32_t number : numbers) {
        change.spheres.push_back(scene.spheres[number]);
        change.spheres.back().hidden = hide;
    }
    return {std::move(change), (hide ? "Hide " : "Show ") + title_of(scene, numbers)};
}

std::string as_label(std::string_view text) {
    std::string label;
    for (const char c : shown_text(text)) {
        if (c == '#' && label.ends_with('#')) label += ' ';
        label += c;
    }
    return label;
}

}  // namespace sphereview

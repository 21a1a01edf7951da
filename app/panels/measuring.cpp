#include "panels/measuring.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <numbers>
#include <tuple>

#include "panels/math_text.hpp"
#include "panels/number_field.hpp"
#include "panels/widgets.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr int digits = 6;
constexpr double degrees_of_radian = 180.0 / std::numbers::pi;

const char* next_click(std::size_t spheres) {
    switch (spheres) {
        case 0: return "Click a sphere, then another one: their distance. A third gives the angle, a fourth the dihedral.";
        case 1: return "Click the sphere to measure to.";
        case 2: return "A third sphere gives the angle.";
        case 3: return "A fourth sphere gives the dihedral.";
        default: return "Another click begins anew.";
    }
}

void draw_values(const std::vector<Measure>& measures) {
    if (!ImGui::BeginTable("##measures", 2)) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    const auto text_of = [](const Measure& one) { return value_text(one, digits); };
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, widest_of(measures, text_of));
    for (const Measure& one : measures) {
        ImGui::TableNextColumn();
        wrapped_text(one.name);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(text_of(one).c_str());
        explain_item(shortest(one.value));
    }
    ImGui::EndTable();
}

// The nearest place to that within the area, which may have become smaller.
ImVec2 within(const Rectangle& area, ImVec2 place, ImVec2 size, float margin) {
    const auto nearest = [&](float at, float length, float from, float room) {
        return std::max(std::min(at, from + room - margin - length), from + margin);
    };
    return {nearest(place.x, size.x, area.x, area.width), nearest(place.y, size.y, area.y, area.height)};
}

// What the window should leave free: the places where the measured spheres are seen, and what else is drawn over the picture.
struct Uncovered {
    const std::vector<ImVec2>& spheres;
    const std::vector<Rectangle>& marks;
};

// How much a window there covers: of the measured spheres, and of the area of marks.
struct Cover {
    std::ptrdiff_t spheres = 0;
    float marks = 0.0F;

    auto operator<=>(const Cover&) const = default;
};

Cover cover_of(const Uncovered& uncovered, ImVec2 low, ImVec2 size, float margin) {
    const auto covers = [&](const ImVec2& at) {
        return at.x > low.x - margin && at.y > low.y - margin && at.x < low.x + size.x + margin && at.y < low.y + size.y + margin;
    };
    Cover cover{std::ranges::count_if(uncovered.spheres, covers)};
    for (const Rectangle& mark : uncovered.marks) {
        const float width = std::min(low.x + size.x, mark.x + mark.width) - std::max(low.x, mark.x);
        const float height = std::min(low.y + size.y, mark.y + mark.height) - std::max(low.y, mark.y);
        cover.marks += std::max(width, 0.0F) * std::max(height, 0.0F);
    }
    return cover;
}

// The place where a window of that size covers least: a corner, or beside a mark; of several the nearest to the upper left corner.
ImVec2 free_place(const Uncovered& uncovered, const Rectangle& area, ImVec2 size, float margin) {
    std::vector<ImVec2> edges = {{area.x, area.y}, {area.x + area.width, area.y + area.height}};
    for (const Rectangle& mark : uncovered.marks) {
        edges.emplace_back(mark.x + mark.width, mark.y + mark.height);
        edges.emplace_back(mark.x - margin - size.x, mark.y - margin - size.y);
    }
    std::optional<std::tuple<Cover, float, ImVec2>> best;
    for (const ImVec2& across : edges) {
        for (const ImVec2& down : edges) {
            const ImVec2 place = within(area, {across.x, down.y}, size, margin);
            const Cover cover = cover_of(uncovered, place, size, margin);
            const float away = std::hypot(place.x - area.x, place.y - area.y);
            if (!best || std::tie(cover, away) < std::tie(std::get<0>(*best), std::get<1>(*best))) best = {cover, away, place};
        }
    }
    return std::get<ImVec2>(*best);
}

// Moves the current window within the area. When its contents have changed it also goes from where it covers something; where the
// person has dragged it, only from a measured sphere.
void place_window_of(Measuring& measuring, const Uncovered& uncovered, const Rectangle& area, float margin) {
    const ImVec2 present = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    const bool dragged = measuring.placed && (measuring.placed->x != present.x || measuring.placed->y != present.y);
    ImVec2 place = within(area, present, size, margin);
    if (measuring.measured != measuring.spheres.size() || size.x != measuring.size.x || size.y != measuring.size.y) {
        const Cover cover = cover_of(uncovered, place, size, margin);
        if (cover.spheres > 0 || (cover.marks > 0.0F && !dragged)) place = free_place(uncovered, area, size, margin);
        if (!dragged) measuring.placed = place;
    }
    measuring.size = size;
    measuring.measured = measuring.spheres.size();
    if (place.x != present.x || place.y != present.y) ImGui::SetWindowPos(place);
}

}  // namespace

std::optional<double> angle_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 first = unit(a - b);
    const glm::dvec3 second = unit(c - b);
    if (first == glm::dvec3(0.0) || second == glm::dvec3(0.0)) return std::nullopt;
    // The arc tangent, which is right also for angles near 0 and 180.
    return std::atan2(length_of(cross(first, second)), dot(first, second)) * degrees_of_radian;
}

std::optional<double> dihedral_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d,
                                  bool left_handed) {
    const glm::dvec3 along = unit(c - b);
    const glm::dvec3 before = cross(unit(b - a), along);
    const glm::dvec3 after = cross(along, unit(d - c));
    constexpr double on_a_line = 1e-9;
    if (length_of(before) < on_a_line || length_of(after) < on_a_line) return std::nullopt;
    const double angle = std::atan2(dot(cross(before, after), along), dot(before, after)) * degrees_of_radian;
    return left_handed && angle < 180.0 ? -angle + 0.0 : angle;
}

void measure(Measuring& measuring, const Document& document, std::uint32_t sphere) {
    if (measuring.revision != document.names_revision() || measuring.spheres.size() == most_measured) measuring.spheres.clear();
    measuring.revision = document.names_revision();
    if (measuring.spheres.empty() || measuring.spheres.back() != sphere) measuring.spheres.push_back(sphere);
}

std::vector<Measure> measures_of(const Measuring& measuring, const Scene& scene, bool left_handed) {
    const std::vector<std::uint32_t>& spheres = measuring.spheres;
    const auto is_there = [&](std::uint32_t number) { return number < scene.spheres.size(); };
    if (!std::ranges::all_of(spheres, is_there)) return {};
    std::vector<Measure> measures;
    const auto place = [&](std::size_t i) { return scene.spheres[spheres[i]].center; };
    const auto title = [&](std::size_t i) { return title_of(scene, spheres[i]); };
    for (std::size_t i = 0; i + 1 < spheres.size(); ++i) {
        measures.push_back({"distance " + title(i) + " to " + title(i + 1), length_of(place(i + 1) - place(i)), false, i});
    }
    for (std::size_t i = 0; i + 2 < spheres.size(); ++i) {
        const auto angle = angle_of(place(i), place(i + 1), place(i + 2));
        const std::string name = "angle " + title(i) + ", " + title(i + 1) + ", " + title(i + 2);
        if (angle) measures.push_back({name, *angle, true, i + 1});
    }
    if (spheres.size() == most_measured) {
        const auto angle = dihedral_of(place(0), place(1), place(2), place(3), left_handed);
        const std::string name = "dihedral " + title(0) + ", " + title(1) + ", " + title(2) + ", " + title(3);
        if (angle) measures.push_back({name, *angle, true, 1});
    }
    return measures;
}

std::string value_text(const Measure& measure, int significant) {
    return in_glyphs(number_text(measure.value, significant)) + (measure.is_angle ? degree_sign : "");
}

std::string in_words(const Measure& measure, bool in_full) {
    return measure.name + " = " +
           (in_full ? shortest(measure.value) + (measure.is_angle ? degree_sign : "") : value_text(measure, digits));
}

void draw_measuring(const PanelContext& context, Measuring& measuring, const Rectangle& area, const std::vector<ImVec2>& places,
                    const std::vector<Rectangle>& marks) {
    if (!measuring.on) return;
    if (measuring.revision != context.document.names_revision()) measuring.spheres.clear();
    const float margin = 12.0F * context.scale;
    const float room = std::max(area.width - 2.0F * margin, 1.0F);
    // With a third of the picture beside it, where the legend has room.
    constexpr float part = 0.65F;
    const float wanted = std::max(std::min(340.0F * context.scale, part * area.width), 8.0F * ImGui::GetFontSize());
    const float width = std::min(wanted, room);
    ImGui::SetNextWindowPos({area.x + margin, area.y + margin}, ImGuiCond_Appearing);
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, std::max(area.height - 2.0F * margin, 1.0F)});
    ImGui::SetNextWindowBgAlpha(0.92F);
    // What it covers may be what is to be measured, so it can be moved.
    constexpr ImGuiWindowFlags flags = (quiet_window & ~ImGuiWindowFlags_NoMove) | ImGuiWindowFlags_AlwaysAutoResize;
    if (ImGui::Begin("###measuring", nullptr, flags)) {
        // Before, its size is not known.
        if (!ImGui::IsWindowAppearing()) place_window_of(measuring, {places, marks}, area, margin);
        const std::vector<Measure> measures = measures_of(measuring, context.document.scene(), !context.view.mirrored);
        draw_title(context, "Measure");
        if (measuring.spheres.size() == 1) wrapped_text(title_of(context.document.scene(), measuring.spheres.front()));
        draw_values(measures);
        dim_text(next_click(measuring.spheres.size()));
        if (draw_button(context, "Copy", "measure copy", "", !measures.empty())) {
            std::string text;
            for (const Measure& one : measures) text += in_words(one, true) + "\n";
            ImGui::SetClipboardText(text.c_str());
        }
        same_line_for("Begin anew");
        if (draw_button(context, "Begin anew", "measure again", "", !measuring.spheres.empty())) measuring.spheres.clear();
        same_line_for("End");
        if (draw_button(context, "End", "measure end")) measuring = {};
        note_window(context, "measuring");
    }
    ImGui::End();
}

}  // namespace sphereview

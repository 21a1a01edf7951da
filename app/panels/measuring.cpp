#include "panels/measuring.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
    float widest = 0.0F;
    for (const Measure& one : measures) {
        widest = std::max(widest, width_of(value_text(one, digits)));
    }
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, widest);
    for (const Measure& one : measures) {
        ImGui::TableNextColumn();
        wrapped_text(one.name);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(value_text(one, digits).c_str());
        explain_item(shortest(one.value));
    }
    ImGui::EndTable();
}

// Moves the current window to the nearest place within the area, which may have become smaller.
void keep_within(const Rectangle& area, float margin) {
    const ImVec2 low = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    const auto nearest = [&](float place, float length, float from, float room) {
        return std::max(std::min(place, from + room - margin - length), from + margin);
    };
    const ImVec2 place{nearest(low.x, size.x, area.x, area.width), nearest(low.y, size.y, area.y, area.height)};
    if (place.x != low.x || place.y != low.y) ImGui::SetWindowPos(place);
}

// Moves the current window, of which a place is covered, to the first corner where it covers none.
void uncover(const std::vector<ImVec2>& places, const Rectangle& area, float margin) {
    const ImVec2 size = ImGui::GetWindowSize();
    const auto covers = [&](ImVec2 low) {
        return std::ranges::any_of(places, [&](const ImVec2& at) {
            return at.x > low.x - margin && at.y > low.y - margin && at.x < low.x + size.x + margin &&
                   at.y < low.y + size.y + margin;
        });
    };
    if (!covers(ImGui::GetWindowPos())) return;
    const float right = area.x + area.width - margin - size.x;
    const float bottom = area.y + area.height - margin - size.y;
    for (const ImVec2& corner : {ImVec2(area.x + margin, area.y + margin), ImVec2(right, area.y + margin),
                                 ImVec2(area.x + margin, bottom), ImVec2(right, bottom)}) {
        if (!covers(corner)) return ImGui::SetWindowPos(corner);
    }
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

void draw_measuring(const PanelContext& context, Measuring& measuring, const Rectangle& area, const std::vector<ImVec2>& places) {
    if (!measuring.on) return;
    if (measuring.revision != context.document.names_revision()) measuring.spheres.clear();
    const float margin = 12.0F * context.scale;
    const float room = std::max(area.width - 2.0F * margin, 1.0F);
    // At the left, with a third of the picture beside it: there is the legend.
    constexpr float part = 0.65F;
    const float wanted = std::max(std::min(340.0F * context.scale, part * area.width), 8.0F * ImGui::GetFontSize());
    const float width = std::min(wanted, room);
    ImGui::SetNextWindowPos({area.x + margin, area.y + margin}, ImGuiCond_Appearing);
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, std::max(area.height - 2.0F * margin, 1.0F)});
    ImGui::SetNextWindowBgAlpha(0.92F);
    // What it covers may be what is to be measured, so it can be moved.
    constexpr ImGuiWindowFlags flags = (quiet_window & ~ImGuiWindowFlags_NoMove) | ImGuiWindowFlags_AlwaysAutoResize;
    if (ImGui::Begin("###measuring", nullptr, flags)) {
        if (!ImGui::IsWindowAppearing()) keep_within(area, margin);
        // Not at other times: then it is where the person has dragged it.
        const ImVec2 size = ImGui::GetWindowSize();
        if (measuring.measured != measuring.spheres.size() || size.x != measuring.size.x || size.y != measuring.size.y) {
            uncover(places, area, margin);
        }
        measuring.size = size;
        measuring.measured = measuring.spheres.size();
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

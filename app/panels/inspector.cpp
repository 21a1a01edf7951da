#include "panels/inspector.hpp"

#include <imgui.h>

#include "base/text.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

constexpr std::size_t most_hits_shown = 20;  // a ray may hit a million

const ImVec4 above_zero{0.40F, 0.85F, 0.45F, 1.0F};
const ImVec4 zero{1.00F, 0.75F, 0.25F, 1.0F};
const ImVec4 below_zero{1.00F, 0.42F, 0.40F, 1.0F};

void colored_line(const std::string& text, const ImVec4& color) {
    ImGui::PushStyleColor(ImGuiCol_Text, on_panel(color));
    wrapped_text(text);
    ImGui::PopStyleColor();
}

void draw_ray(const PixelExplanation& e) {
    wrapped_text("P = O + t D");
    wrapped_text(origin_in_words(e));
    wrapped_text(direction_in_words(e));
    ImGui::Spacing();
    dim_text("||P - C||^2 = r^2, with P = O + t D:");
    wrapped_text("D.D t^2 + 2 D.(O - C) t + (O - C).(O - C) - r^2 = 0");
    dim_text("a = D.D,  b = 2 D.(O - C),  c = (O - C).(O - C) - r^2");
    dim_text("discriminant = b^2 - 4 a c,  t1, t2 = (-b -+ sqrt(discriminant)) / (2 a)");
}

void draw_title(const PanelContext& context, const ExplainedHit& hit, bool seen) {
    const Scene& scene = context.document.scene();
    const auto number = static_cast<std::uint32_t>(hit.number);
    const Sphere& sphere = scene.spheres[number];
    const float side = ImGui::GetTextLineHeight();
    draw_swatch(sphere.color, ImGui::GetCursorScreenPos(), side, context.scale);
    ImGui::Dummy({side, side});
    ImGui::SameLine();
    ImGui::TextUnformatted(title_of(scene, number).c_str());
    note_widget(context, "hit " + std::to_string(number));
    if (seen) {
        ImGui::SameLine();
        ImGui::TextColored(on_panel(above_zero), "seen");
    }
    dim_text("C = " + vector_in_words(sphere.center) + ", r = " + shortest(sphere.radius));
}

void draw_hit(const PanelContext& context, const ExplainedHit& hit, bool seen) {
    ImGui::Separator();
    draw_title(context, hit, seen);
    const HitInWords words = in_words(hit);
    wrapped_text("a = " + words.a);
    wrapped_text("b = " + words.b);
    wrapped_text("c = " + words.c);
    colored_line("discriminant = " + words.discriminant + "  " + words.roots, hit.discriminant_sign > 0 ? above_zero : zero);
    wrapped_text("t1 = " + words.t1);
    wrapped_text("t2 = " + words.t2);
    dim_text(why(hit));
    wrapped_text("t = " + words.t);
    wrapped_text("point = " + words.point);
    wrapped_text("normal = " + words.normal);
    if (hit.as_near_as_last) colored_line("exactly as near as the sphere before it, which comes first in the file", zero);
}

// The ray from the point to the sun.
void draw_sun(const PanelContext& context, const InspectedPixel& pixel) {
    if (pixel.sun.empty() || !pixel.place.sun) return;
    wrapped_text("sun: L = " + vector_in_words(pixel.place.sun->direction));
    note_widget(context, "sun ray");
    colored_line("The sun " + pixel.sun + ".", pixel.sun_shines ? above_zero : below_zero);
}

void draw_rest(const PixelExplanation& e) {
    if (e.missed > 0) colored_line(in_groups(static_cast<std::uint64_t>(e.missed)) + " missed: discriminant < 0", below_zero);
    const std::string behind = behind_in_words(e);
    if (e.elsewhere > 0) wrapped_text(in_groups(static_cast<std::uint64_t>(e.elsewhere)) + " elsewhere or " + behind + ": not hit");
    if (e.behind > 0) wrapped_text(in_groups(static_cast<std::uint64_t>(e.behind)) + " " + behind + ": no positive root");
    if (e.hidden > 0) dim_text(in_groups(static_cast<std::uint64_t>(e.hidden)) + " hidden");
}

}  // namespace

void draw_inspector(const PanelContext& context, const std::optional<InspectedPixel>& pixel) {
    if (!pixel) {
        dim_text("Point at the picture to see the arithmetic of a pixel.");
        return;
    }
    const Scene& scene = context.document.scene();
    const PixelExplanation& e = pixel->explanation;
    const auto& [place, size, camera, revision, sun] = pixel->place;
    wrapped_text("pixel " + std::to_string(place.x) + ", " + std::to_string(place.y) + " of " + std::to_string(size.width) + " x " +
                 std::to_string(size.height));
    draw_ray(e);
    ImGui::Spacing();
    if (e.hits.empty()) wrapped_text("No hit: the pixel shows the background, " + to_string(scene.background) + ".");
    std::size_t shown = 0;
    for (const ExplainedHit& hit : e.hits) {
        // An explanation may be of the scene of the last frame.
        if (static_cast<std::size_t>(hit.number) >= scene.spheres.size()) continue;
        if (shown == most_hits_shown) break;
        draw_hit(context, hit, shown == 0);
        if (shown == 0) draw_sun(context, *pixel);
        ++shown;
    }
    const std::uint64_t all_hits = e.hits.size() + static_cast<std::uint64_t>(e.farther);
    if (all_hits > shown) {
        ImGui::Separator();
        dim_text("and " + in_groups(all_hits - shown) + " more hits, farther away");
    }
    ImGui::Separator();
    draw_rest(e);
    dim_text(std::string("Decided: ") + level_in_words(e.level) + ".");
}

}  // namespace sphereview

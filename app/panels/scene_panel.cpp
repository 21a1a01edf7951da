#include "panels/scene_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "panels/color_edit.hpp"
#include "panels/field.hpp"
#include "panels/number_text.hpp"

namespace sphereview {

namespace {

constexpr std::array<const char*, 3> usual_backgrounds = {"black", "white", "transparent"};
constexpr Background first_of_others = {{128, 128, 128}, false};  // until another is chosen

void change_background(const PanelContext& context, const Background& background, std::uint64_t gesture) {
    if (background == context.document.scene().background) return;
    context.actions.emplace_back(EditScene{ChangeBackground{background}, "Change background", gesture});
}

void draw_background(const PanelContext& context) {
    const Background& present = context.document.scene().background;
    const std::string spelling = to_string(present);
    const bool usual = !spelling.starts_with('#');
    begin_field(context, "background");
    const float swatch = usual ? 0.0F : ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(std::max(1.0F, ImGui::GetContentRegionAvail().x - swatch));
    const bool open = ImGui::BeginCombo("##background", usual ? spelling.c_str() : "colour");
    note_widget(context, "background");
    if (open) {
        for (const char* name : usual_backgrounds) {
            if (ImGui::Selectable(name, spelling == name)) {
                Background chosen;
                if (parse_background(name, chosen)) change_background(context, chosen, 0);
            }
            note_widget(context, std::string("background ") + name);
        }
        if (ImGui::Selectable("colour", !usual) && usual) change_background(context, first_of_others, 0);
        note_widget(context, "background colour");
        ImGui::EndCombo();
    }
    if (usual) return;
    ImGui::SameLine(0.0F, ImGui::GetStyle().ItemInnerSpacing.x);
    Background edited = present;
    const auto gesture = draw_color_edit(context, "##background color", edited.color, false);
    note_widget(context, "background color");
    if (gesture) change_background(context, edited, *gesture);
}

void redraw(const PanelContext& context) {
    begin_field(context, "frame");
    std::int64_t frame = context.frame;
    const std::int64_t first = 0;
    const std::int64_t last = context.frames - 1;
    ImGui::SetNextItemWidth(-1.0F);
    if (ImGui::SliderScalar("##frame", ImGuiDataType_S64, &frame, &first, &last, nullptr, ImGuiSliderFlags_AlwaysClamp)) {
        if (frame != context.frame) context.actions.emplace_back(ShowFrame{frame});
    }
    note_widget(context, "frame");
}

// Shortened; in full as a tooltip.
void draw_vector(const PanelContext& context, const char* label, const glm::dvec3& v) {
    begin_field(context, label);
    ImGui::TextDisabled("%s, %s, %s", short_text(v.x).c_str(), short_text(v.y).c_str(), short_text(v.z).c_str());
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s\n%s\n%s", shortest(v.x).c_str(), shortest(v.y).c_str(), shortest(v.z).c_str());
    }
}

}  // namespace

void draw_scene_panel(const PanelContext& context) {
    const Scene& scene = context.document.scene();
    if (context.frames > 1) redraw(context);
    draw_background(context);
    const std::vector<float> widths = button_widths({"Use this view", "Home"});
    draw_command_button(context, CommandId::use_view_as_camera, "Use this view", "use view", widths[0]);
    ImGui::SameLine();
    draw_command_button(context, CommandId::go_home, "Home", "home", widths[1]);
    const bool open = ImGui::TreeNodeEx("camera", ImGuiTreeNodeFlags_NoTreePushOnOpen);
    note_widget(context, "camera");
    if (!open) return;
    draw_vector(context, "eye", scene.camera.eye);
    draw_vector(context, "centre", scene.camera.center);
    draw_vector(context, "right", scene.camera.right);
    draw_vector(context, "up", scene.camera.up);
}

}  // namespace sphereview

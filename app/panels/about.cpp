#include "panels/about.hpp"

#include <imgui.h>

#include <algorithm>

#include "base/text.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) lines.push_back(shown_text(take_line(text)));
    return lines;
}

// Only the lines that are seen are drawn: ImGui cannot draw all of so long a text.
void draw_licenses(const std::vector<std::string>& lines) {
    ImGui::BeginChild("##licences", {0.0F, 0.0F}, true);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(lines.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const std::string& line = lines[static_cast<std::size_t>(i)];
            ImGui::TextUnformatted(line.data(), line.data() + line.size());
        }
    }
    ImGui::EndChild();
}

}  // namespace

void draw_about(const PanelContext& context, About& about, const std::string& name_and_version, std::string (*licenses)(),
                const std::string& renderer) {
    if (!about.shown) return;
    if (about.lines.empty() && licenses != nullptr) about.lines = lines_of(licenses());
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    const ImVec2 size(std::min(720.0F * context.scale, 0.95F * viewport->WorkSize.x),
                      std::min(560.0F * context.scale, 0.9F * viewport->WorkSize.y));
    ImGui::SetNextWindowPos(viewport->GetWorkCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
    if (ImGui::Begin("About sphereview###about", &about.shown, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
        draw_heading(context, name_and_version, "Ray traced spheres, exact to the pixel");
        const std::string facts = "Renderer: " + renderer + "\nDear ImGui " + ImGui::GetVersion();
        wrapped_text(facts);
        if (ImGui::Button("Copy")) ImGui::SetClipboardText((name_and_version + "\n" + facts + "\n").c_str());
        note_widget(context, "about copy");
        explain_item("Copies the version and the renderer, for a report");
        ImGui::Spacing();
        dim_text("The licences of this program and of the parts of others in it:");
        draw_licenses(about.lines);
        note_rectangle(context, "about", ImGui::GetWindowPos(), ImGui::GetWindowSize());
    }
    ImGui::End();
}

}  // namespace sphereview

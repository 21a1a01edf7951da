#include "panels/about.hpp"

#include <imgui.h>

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
    if (begin_text_window(context, "About sphereview###about", about.shown, {720.0F, 560.0F})) {
        draw_heading(context, name_and_version, "Ray traced spheres, exact to the pixel");
        const std::string facts = "Renderer: " + renderer + "\nDear ImGui " + ImGui::GetVersion();
        wrapped_text(facts);
        if (draw_button(context, "Copy", "about copy", "Copies the version and the renderer, for a report")) {
            ImGui::SetClipboardText((name_and_version + "\n" + facts + "\n").c_str());
        }
        ImGui::Spacing();
        dim_text("The licences of this program and of the parts of others in it:");
        draw_licenses(about.lines);
        note_window(context, "about");
    }
    ImGui::End();
}

}  // namespace sphereview

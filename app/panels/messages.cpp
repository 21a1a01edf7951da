#include "panels/messages.hpp"

#include <imgui.h>

#include <algorithm>

namespace sphereview {

namespace {

constexpr ImGuiWindowFlags quiet_window = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                          ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

void wrapped(const std::string& text, float wrap_at) {
    ImGui::PushTextWrapPos(wrap_at);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
}

void note_window(const PanelContext& context, const std::string& name) {
    if (context.rectangles == nullptr) return;
    const ImVec2 low = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    (*context.rectangles)[name] = {low.x, low.y, low.x + size.x, low.y + size.y};
}

void draw_announcement(const PanelContext& context, const std::string& text, const MessageArea& area) {
    const float margin = 16.0F * context.scale;
    const float padding = ImGui::GetStyle().WindowPadding.x;
    const float most = std::max(area.width - 2.0F * (margin + padding), 4.0F * ImGui::GetFontSize());
    ImGui::SetNextWindowPos({area.x + 0.5F * area.width, area.y + area.height - margin}, ImGuiCond_Always, {0.5F, 1.0F});
    ImGui::SetNextWindowBgAlpha(0.9F);
    // Clicks go through it to the picture.
    if (ImGui::Begin("###announcement", nullptr,
                     quiet_window | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoInputs)) {
        wrapped(text, padding + most);
        note_window(context, "message announcement");
    }
    ImGui::End();
}

// Returns whether Cancel was pressed.
bool draw_work(const PanelContext& context, const WorkShown& work, const MessageArea& area) {
    const float margin = 16.0F * context.scale;
    const float width = std::max(std::min(420.0F * context.scale, area.width - 2.0F * margin), 8.0F * ImGui::GetFontSize());
    ImGui::SetNextWindowPos({area.x + 0.5F * area.width, area.y + 0.4F * area.height}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, std::max(area.height, 1.0F)});
    ImGui::SetNextWindowBgAlpha(0.9F);
    bool cancelled = false;
    if (ImGui::Begin("###work", nullptr, quiet_window | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoScrollbar)) {
        wrapped(work.text, width - ImGui::GetStyle().WindowPadding.x);
        const std::string percent = work.fraction ? std::to_string(static_cast<int>(100.0 * *work.fraction)) + " %" : "";
        ImGui::ProgressBar(static_cast<float>(work.fraction.value_or(0.0)), {-1.0F, 0.0F}, percent.c_str());
        if (work.can_cancel) {
            cancelled = ImGui::Button("Cancel");
            note_widget(context, "cancel work");
        }
        note_window(context, "message work");
    }
    ImGui::End();
    return cancelled;
}

struct Trouble {
    const char* name;  // "scene error"
    std::string heading;
    const std::string& text;
    bool log = false;
    float top = 0.0F;  // where its window begins
};

// The heading, and the button that closes. Returns whether it was pressed.
bool draw_heading(const PanelContext& context, const Trouble& trouble) {
    const float button = ImGui::CalcTextSize("Close").x + 2.0F * ImGui::GetStyle().FramePadding.x;
    const float left = ImGui::GetCursorPosX();
    const float width = ImGui::GetContentRegionAvail().x;
    wrapped(trouble.heading, left + std::max(width - button - ImGui::GetStyle().ItemSpacing.x, button));
    ImGui::SameLine(left + std::max(width - button, 0.0F));
    const bool closed = ImGui::SmallButton("Close");
    note_widget(context, std::string("close ") + trouble.name);
    return closed;
}

// A red-edged box; returns where it ends. `closed`: by its button.
float draw_trouble(const PanelContext& context, const Trouble& trouble, const MessageArea& area, bool& closed) {
    const float margin = 12.0F * context.scale;
    const float width = std::max(area.width - 2.0F * margin, 8.0F * ImGui::GetFontSize());
    ImGui::SetNextWindowPos({area.x + margin, trouble.top + margin});
    // Its height is what the text needs, up to a part of the picture; the rest is scrolled.
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, std::max(0.45F * area.height, 6.0F * ImGui::GetFontSize())});
    ImGui::PushStyleColor(ImGuiCol_Border, ImVec4(0.88F, 0.27F, 0.25F, 1.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 2.0F * context.scale);
    float bottom = trouble.top;
    if (ImGui::Begin((std::string("###") + trouble.name).c_str(), nullptr, quiet_window | ImGuiWindowFlags_AlwaysAutoResize)) {
        closed = draw_heading(context, trouble);
        const auto& fonts = ImGui::GetIO().Fonts->Fonts;
        const bool monospaced = trouble.log && fonts.Size > 1;
#if IMGUI_VERSION_NUM >= 19200
        if (monospaced) ImGui::PushFont(fonts[1], 0.0F);  // in the size of the other
#else
        if (monospaced) ImGui::PushFont(fonts[1]);
#endif
        // Wrapped before the scroll bar whether it is there or not, or it would come and go.
        wrapped(trouble.text, width - ImGui::GetStyle().WindowPadding.x - ImGui::GetStyle().ScrollbarSize);
        if (monospaced) ImGui::PopFont();
        note_window(context, std::string("message ") + trouble.name);
        bottom = ImGui::GetWindowPos().y + ImGui::GetWindowSize().y;
    }
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    return bottom;
}

}  // namespace

ClosedMessages draw_messages(const PanelContext& context, const Messages& messages, const MessageArea& area) {
    ClosedMessages closed;
    float top = area.y;
    if (!messages.scene_error.empty()) {
        const Trouble trouble{"scene error", "The scene file cannot be read; the last good scene is shown.", messages.scene_error,
                              false, top};
        top = draw_trouble(context, trouble, area, closed.scene_error);
    }
    if (!messages.shader_error.empty()) {
        const Trouble trouble{"shader error", "A shader does not compile; the last good one is running.", messages.shader_error,
                              true, top};
        draw_trouble(context, trouble, area, closed.shader_error);
    }
    if (messages.work) closed.work = draw_work(context, *messages.work, area);
    if (!messages.announcement.empty()) draw_announcement(context, messages.announcement, area);
    return closed;
}

}  // namespace sphereview

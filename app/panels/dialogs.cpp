#include "panels/dialogs.hpp"

#include <imgui.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "panels/dialog_parts.hpp"
#include "panels/labels.hpp"

namespace sphereview {

namespace {

const std::string& heading_of(const Question& question) { return question.title; }
const std::string& heading_of(const FileBrowser& browser) { return browser.title; }
std::string heading_of(const ExportForm&) { return "Export picture"; }

// A browser's list takes what room there is; the others are as large as their content.
bool resizes_itself(const Dialog& dialog) { return !std::holds_alternative<FileBrowser>(dialog); }

void place_next_window(const PanelContext& context, const Dialog& dialog) {
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport->GetCenter(), ImGuiCond_Appearing, ImVec2(0.5F, 0.5F));
    if (resizes_itself(dialog)) return;
    ImGui::SetNextWindowSize(
        {std::min(720.0F * context.scale, 0.95F * viewport->Size.x), std::min(520.0F * context.scale, 0.95F * viewport->Size.y)},
        ImGuiCond_Appearing);
}

// The question is gone when its answer is told.
Decision answered(const Question& question, int number) {
    return {true, [answer = question.answer, number] {
                if (answer) answer(number);
            }};
}

// By the close button.
Decision cancelled(const Dialog& dialog) {
    const auto* question = std::get_if<Question>(&dialog);
    return question == nullptr ? Decision{true, {}} : answered(*question, question->cancel);
}

// Draws one dialog and, inside of it as ImGui wants it, those above. What is decided comes from the last.
Decision draw_from(const PanelContext& context, Dialogs& dialogs, std::size_t index, const DialogKeys& keys) {
    Dialog& dialog = dialogs[index];
    const bool top = index + 1 == dialogs.size();
    const std::string name = as_label(std::visit([](const auto& one) { return std::string(heading_of(one)); }, dialog)) +
                             "###dialog " + std::to_string(index) + " " + id_of(dialog);
    if (!ImGui::IsPopupOpen(name.c_str())) ImGui::OpenPopup(name.c_str());
    place_next_window(context, dialog);
    ImGuiWindowFlags flags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse;
    if (resizes_itself(dialog)) flags |= ImGuiWindowFlags_AlwaysAutoResize;
    // A question has arrow keys of its own, and they work whether ImGui's are on or not.
    if (std::holds_alternative<Question>(dialog)) flags |= ImGuiWindowFlags_NoNav;
    bool open = true;
    if (!ImGui::BeginPopupModal(name.c_str(), &open, flags)) return open ? Decision{} : cancelled(dialog);
    PanelContext own_context = context;
    if (!top) own_context.rectangles = nullptr;  // of what lies below nothing can be clicked
    Decision decision =
        std::visit([&](auto& one) { return draw_content(own_context, one, top ? keys : DialogKeys{}, dialogs); }, dialog);
    if (!top)
        decision = draw_from(context, dialogs, index + 1, keys);
    else if (decision.done)
        ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return decision;
}

}  // namespace

std::string id_of(const Dialog& dialog) {
    if (const auto* question = std::get_if<Question>(&dialog)) return question->id;
    return std::holds_alternative<ExportForm>(dialog) ? "export" : "browser";
}

void draw_dialogs(const PanelContext& context, Dialogs& dialogs, const DialogKeys& keys) {
    if (dialogs.empty()) return;
    const Decision decision = draw_from(context, dialogs, 0, keys);
    if (decision.done) dialogs.pop_back();
    if (decision.then) decision.then();
}

Decision draw_content(const PanelContext& context, Question& question, const DialogKeys& keys, Dialogs&) {
    const int count = static_cast<int>(question.answers.size());
    assert(count > 0 && question.cancel >= 0 && question.cancel < count);
    const float width = std::min(440.0F * context.scale, 0.85F * ImGui::GetMainViewport()->Size.x);
    ImGui::Dummy({width, 0.0F});
    draw_text(question.text, width, 0.5F * ImGui::GetMainViewport()->Size.y);
    ImGui::Dummy({0.0F, 0.5F * ImGui::GetFontSize()});

    question.focused = (question.focused + keys.step % count + count) % count;
    std::optional<int> chosen;
    for (int i = 0; i < count; ++i) {
        const std::string& answer = question.answers[static_cast<std::size_t>(i)];
        if (i > 0) ImGui::SameLine();
        const bool focused = i == question.focused;
        if (focused) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
        const float least = 88.0F * context.scale;
        const float wanted = ImGui::CalcTextSize(answer.c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x;
        ImGui::PushID(i);
        if (ImGui::Button(as_label(answer).c_str(), {std::max(least, wanted), 0.0F})) chosen = i;
        ImGui::PopID();
        if (focused) ImGui::PopStyleColor();
        note_widget(context, "answer " + std::to_string(i));
        note_widget(context, "answer " + answer);
    }
    if (!chosen && keys.escape) chosen = question.cancel;
    if (!chosen && keys.enter) chosen = question.focused;
    if (!chosen) return {};
    return answered(question, *chosen);
}

void ask_to_replace(Dialogs& dialogs, const std::string& path, std::function<void()> then) {
    Question question;
    question.id = "replace";
    question.title = "Replace the file?";
    question.text = on_one_line(path) + "\n\nexists already.";
    question.answers = {"Replace", "Cancel"};
    question.cancel = 1;
    question.focused = 1;
    question.answer = [&dialogs, then = std::move(then)](int number) {
        if (number != 0) return;
        dialogs.pop_back();
        then();
    };
    dialogs.emplace_back(std::move(question));
}

}  // namespace sphereview

#include "panels/dialogs.hpp"

#include <imgui.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "base/text.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

float text_height(const std::string& unsafe, float width) { return wrapped_height(shown_lines(unsafe), width); }

// Wrapped text; what is higher than `most` is scrolled, so that the buttons below stay in the window.
void draw_text(const std::string& text, float width, float most) {
    const bool scrolled = text_height(text, width) > most;
    const float wrap_at = scrolled ? width - ImGui::GetStyle().ScrollbarSize : ImGui::GetCursorPosX() + width;
    if (scrolled) ImGui::BeginChild("text", {width, most});
    wrapped_text(text, wrap_at);
    if (scrolled) ImGui::EndChild();
}

constexpr float form_button_width = 96.0F;

float highest_fault() { return 5.0F * ImGui::GetTextLineHeight(); }

void draw_side(const PanelContext& context, const char* name, int& side) {
    // Wider than an int, so that what is far too large is not taken for something else.
    std::int64_t typed = side;
    ImGui::SetNextItemWidth(96.0F * context.scale);
    if (ImGui::InputScalar((std::string("##") + name).c_str(), ImGuiDataType_S64, &typed)) {
        side = static_cast<int>(std::clamp<std::int64_t>(typed, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
    }
    note_widget(context, std::string("export ") + name);
}

std::string text_of(PictureSize size) { return std::to_string(size.width) + " x " + std::to_string(size.height); }

// A browser's list takes what room there is; a question is as large as its content.
bool resizes_itself(const Dialog& dialog) { return !std::holds_alternative<FileBrowser>(dialog); }

void place_next_window(const PanelContext& context, const Dialog& dialog) {
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport->GetCenter(), ImGuiCond_Appearing, ImVec2(0.5F, 0.5F));
    if (resizes_itself(dialog)) return;
    const float height = std::get<FileBrowser>(dialog).film ? 640.0F : 520.0F;
    ImGui::SetNextWindowSize(
        {std::min(720.0F * context.scale, 0.95F * viewport->Size.x), std::min(height * context.scale, 0.95F * viewport->Size.y)},
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

// Draws one dialog and, inside of its window as ImGui wants it, the dialogs above. The last one's decision is returned.
Decision draw_from(const PanelContext& context, Dialogs& dialogs, std::size_t index, const DialogKeys& keys) {
    Dialog& dialog = dialogs[index];
    const bool top = index + 1 == dialogs.size();
    const std::string name = as_label(std::visit([](const auto& one) { return one.title; }, dialog)) + "###dialog " +
                             std::to_string(index) + " " + id_of(dialog);
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
    // Where something has opened above it, a dialog or a list of choices, the keys are that one's.
    const bool covered = !top || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
#if IMGUI_VERSION_NUM >= 19290
    // A number counts as it is typed, as in the versions before: the Enter that ends it accepts the dialog.
    ImGui::PushItemFlag(ImGuiItemFlags_LiveEditOnInputScalar, true);
#endif
    Decision decision =
        std::visit([&](auto& one) { return draw_content(own_context, one, covered ? DialogKeys{} : keys, dialogs); }, dialog);
#if IMGUI_VERSION_NUM >= 19290
    ImGui::PopItemFlag();
#endif
    if (!top)
        decision = draw_from(context, dialogs, index + 1, keys);
    else if (decision.done)
        ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return decision;
}

}  // namespace

Question replace_question(const std::string& title, const std::string& text, std::function<void(bool)> answer) {
    return {.id = "replace",
            .title = title,
            .text = text,
            .answers = {"Replace", "Cancel"},
            .cancel = 1,
            .answer = [answer = std::move(answer)](int number) { answer(number == 0); },
            .focused = 1};
}

void draw_fault(const std::string& text, float width) {
    if (text.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, on_panel({1.0F, 0.48F, 0.44F, 1.0F}));
    draw_text(text, width, highest_fault());
    ImGui::PopStyleColor();
}

float fault_height(const std::string& text, float width) { return std::min(text_height(text, width), highest_fault()); }

float form_end_width(const PanelContext& context) {
    return 2.0F * form_button_width * context.scale + ImGui::GetStyle().ItemSpacing.x;
}

FormEnd draw_form_end(const PanelContext& context, const std::string& name, const char* ok, bool possible, const DialogKeys& keys) {
    FormEnd end = FormEnd::open;
    const ImVec2 size(form_button_width * context.scale, 0.0F);
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
    ImGui::BeginDisabled(!possible);
    if (ImGui::Button(ok, size)) end = FormEnd::ok;
    ImGui::EndDisabled();
    ImGui::PopStyleColor();
    note_widget(context, name + " ok");
    ImGui::SameLine();
    if (ImGui::Button("Cancel", size)) end = FormEnd::cancel;
    note_widget(context, name + " cancel");
    if (end != FormEnd::open) return end;
    if (keys.escape) return FormEnd::cancel;
    return keys.enter && possible ? FormEnd::ok : FormEnd::open;
}

std::string size_fault(const FileBrowser& browser) {
    if (!browser.size) return "";
    const auto [width, height] = *browser.size;
    if (width < 1 || height < 1) return "Each side needs at least 1 pixel.";
    if (width <= browser.most_pixels / height) return "";
    return "At most " + in_groups(static_cast<std::uint64_t>(browser.most_pixels)) + " pixels, please; these are " +
           in_groups(static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height)) + ".";
}

void draw_size(const PanelContext& context, FileBrowser& browser) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Size in pixels");
    ImGui::SameLine(browser.film ? left_of_film_fields() : 0.0F);
    draw_side(context, "width", browser.size->width);
    ImGui::SameLine();
    ImGui::TextUnformatted("x");
    ImGui::SameLine();
    draw_side(context, "height", browser.size->height);
    constexpr const char* usual = "Usual sizes";
    const float width = width_of(usual) + 2.0F * ImGui::GetFrameHeight();
    if (!same_line_within(width) && browser.film) ImGui::SetCursorPosX(left_of_film_fields());
    ImGui::SetNextItemWidth(width);
    const bool open = ImGui::BeginCombo("##sizes", usual);
    note_widget(context, "export sizes");
    if (!open) return;
    close_list_by_escape();
    const auto offer = [&](const std::string& words, const std::string& widget, PictureSize size) {
        if (ImGui::Selectable(words.c_str(), *browser.size == size)) browser.size = size;
        note_widget(context, widget);
    };
    for (const PictureSize size : {PictureSize{1000, 1000}, PictureSize{1920, 1080}, PictureSize{3840, 2160}}) {
        offer(text_of(size), "export " + text_of(size), size);
    }
    offer("As in the window: " + text_of(browser.view), "export view", browser.view);
    ImGui::EndCombo();
}

std::string id_of(const Dialog& dialog) {
    if (const auto* question = std::get_if<Question>(&dialog)) return question->id;
    const auto& browser = std::get<FileBrowser>(dialog);
    return browser.film ? "film" : browser.size ? "export" : "browser";
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
        const float wanted = button_width(as_label(answer));
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

}  // namespace sphereview

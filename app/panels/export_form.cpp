#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "base/text.hpp"
#include "panels/dialog_parts.hpp"
#include "panels/paths.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

// Where the picture will go; a name without ".png" gets it.
std::string target_of(const ExportForm& form) {
    const std::string path = text_from(typed_path(form.path, path_from(form.folder)));
    return has_ending(path, ".png") ? path : path + ".png";
}

void draw_side(const PanelContext& context, const char* name, int& side) {
    // Wider than an int, so that what is far too large is not taken for something else.
    std::int64_t typed = side;
    ImGui::SetNextItemWidth(96.0F * context.scale);
    if (ImGui::InputScalar((std::string("##") + name).c_str(), ImGuiDataType_S64, &typed)) {
        side = static_cast<int>(std::clamp<std::int64_t>(typed, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
    }
    note_widget(context, std::string("export ") + name);
}

void draw_preset(ExportForm& form, PictureSize size, const std::string& label) {
    if (!ImGui::SmallButton(label.c_str())) return;
    form.width = size.width;
    form.height = size.height;
}

std::string text_of(PictureSize size) { return std::to_string(size.width) + " x " + std::to_string(size.height); }

void draw_presets(const PanelContext& context, ExportForm& form) {
    for (const PictureSize size : {PictureSize{1000, 1000}, PictureSize{1920, 1080}, PictureSize{3840, 2160}}) {
        draw_preset(form, size, text_of(size));
        note_widget(context, "export " + text_of(size));
        ImGui::SameLine();
    }
    if (form.view) {
        draw_preset(form, *form.view, "As in the window: " + text_of(*form.view) + "###view");
        note_widget(context, "export view");
    } else {
        ImGui::NewLine();
    }
}

void draw_name(const PanelContext& context, ExportForm& form, float width) {
    ImGui::TextUnformatted("File");
    ImGui::SetNextItemWidth(width);
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    if (ImGui::InputText("##path", &form.path, ImGuiInputTextFlags_AutoSelectAll)) form.error.clear();
    note_widget(context, "export path");
}

void draw_size(const PanelContext& context, ExportForm& form) {
    ImGui::TextUnformatted("Size in pixels");
    draw_side(context, "width", form.width);
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("x");
    ImGui::SameLine();
    draw_side(context, "height", form.height);
    draw_presets(context, form);
}

}  // namespace

std::string fault_of(const ExportForm& form) {
    if (form.path.find_first_not_of(" \t") == std::string::npos) return "The file needs a name.";
    const fs::path typed = typed_path(form.path, path_from(form.folder));
    std::error_code none;
    if (fs::is_directory(typed, none) || fs::is_directory(path_from(target_of(form)), none)) {
        return "This is a folder: the file needs a name.";
    }
    if (!fs::is_directory(typed.parent_path(), none)) return "There is no folder " + text_from(typed.parent_path()) + ".";
    if (form.width < 1 || form.height < 1) return "Each side needs at least 1 pixel.";
    if (form.width > form.most_pixels / form.height) {
        return "At most " + in_groups(static_cast<std::uint64_t>(form.most_pixels)) + " pixels, please; these are " +
               in_groups(static_cast<std::uint64_t>(form.width) * static_cast<std::uint64_t>(form.height)) + ".";
    }
    return "";
}

Decision draw_content(const PanelContext& context, ExportForm& form, const DialogKeys& keys, Dialogs& dialogs) {
    if (form.folder.empty()) form.folder = text_from(typed_path(form.path, home_folder()).parent_path());
    const float width = std::min(560.0F * context.scale, 0.85F * ImGui::GetMainViewport()->Size.x);
    draw_name(context, form, width);
    draw_size(context, form);
    const std::string fault = fault_of(form);
    draw_fault(fault, width);
    if (fault.empty()) draw_fault(form.error, width);
    ImGui::Dummy({0.0F, 0.3F * ImGui::GetFontSize()});
    switch (draw_form_end(context, "export", "Export", fault.empty(), keys)) {
        case FormEnd::open: return {};
        case FormEnd::cancel: return {true, {}};
        case FormEnd::ok: break;
    }
    const std::string path = target_of(form);
    auto accept = [give = form.accept, path, size = PictureSize{form.width, form.height}] {
        if (give) give(path, size);
    };
    std::error_code none;
    if (!fs::exists(path_from(path), none)) return {true, std::move(accept)};
    return {false, [&dialogs, path, accept = std::move(accept)] { ask_to_replace(dialogs, path, accept); }};
}

}  // namespace sphereview

#include "viewer/export_view.hpp"

#include <system_error>

#include "base/gunzip.hpp"
#include "base/user_folders.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

// NAME.png, NAME-1.png, NAME-2.png, ...: the first that is not there.
fs::path next_free_name(const ViewerState& state) {
    const fs::path folder = state.path.empty() ? pictures_folder() : fs::path(state.path).parent_path();
    const std::string stem = state.path.empty() ? "untitled" : fs::path(without_gzip_ending(state.path)).stem().string();
    std::error_code error;
    fs::path name = folder / (stem + ".png");
    for (int i = 1; fs::exists(fs::symlink_status(name, error)); ++i) name = folder / (stem + "-" + std::to_string(i) + ".png");
    return name;
}

void ask_for_export(ViewerState& state, const std::string& first_path, const std::string& fault) {
    ExportForm form;
    form.path = first_path;
    form.width = state.settings.export_width;
    form.height = state.settings.export_height;
    form.view = state.picture_size;
    form.error = fault;
    form.accept = [&state](const std::string& path, PictureSize size) {
        state.settings.export_width = size.width;
        state.settings.export_height = size.height;
        const auto ask_again = [&state, path](const std::string& why) { ask_for_export(state, path, why); };
        if (state.exporting) return ask_again(state.exporting->path + " is not exported yet");
        start_export(state, path, size, ask_again);
    };
    state.dialogs.push_back(std::move(form));
}

}  // namespace

void export_now(ViewerState& state) {
    if (state.exporting) return;
    start_export(state, next_free_name(state).string(), {state.settings.export_width, state.settings.export_height},
                 [&state](const std::string& why) { report_error(state, "The picture cannot be exported", why); });
}

void ask_for_export(ViewerState& state) { ask_for_export(state, next_free_name(state).string(), ""); }

}  // namespace sphereview

#include "viewer/export_view.hpp"

#include <algorithm>
#include <system_error>

#include "app/failure.hpp"
#include "app/render_picture.hpp"
#include "base/error.hpp"
#include "base/gunzip.hpp"
#include "base/output_file.hpp"
#include "base/text.hpp"
#include "base/user_folders.hpp"
#include "image/png.hpp"

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

// What it said when it could not be done, or "".
std::string try_export(ViewerState& state, const std::string& path, PictureSize size) {
    try {
        export_view(state, path, size);
    } catch (...) {
        return describe_current_exception().message;
    }
    const int samples = state.settings.samples;
    announce(state, "Exported " + path + " (" + std::to_string(size.width) + " x " + std::to_string(size.height) +
                        (samples > 1 ? ", " + std::to_string(samples) + " samples a pixel)" : ")"));
    return "";
}

PictureSize export_size(const ViewerState& state) { return {state.settings.export_width, state.settings.export_height}; }

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
        const std::string why = try_export(state, path, size);
        if (!why.empty()) ask_for_export(state, path, why);
    };
    state.dialogs.push_back(std::move(form));
}

}  // namespace

void export_view(const ViewerState& state, const std::string& path, PictureSize size) {
    const int samples = state.settings.samples;
    if (std::max(size.width, size.height) > longest_side(samples)) {
        throw RenderError("a picture with " + std::to_string(samples) + " samples a pixel can be at most " +
                          in_groups(static_cast<std::uint64_t>(longest_side(samples))) + " pixels wide and high");
    }
    check_output(path);
    Scene scene = state.scene();
    scene.camera = state.camera;
    // The CPU's renderer: the picture is the same on all, and the window's context keeps what it holds.
    OpenBackend cpu;
    Timings timings;
    PictureFacts facts;
    Progress progress{false};
    const Image picture =
        render_picture(cpu, scene, drawn_spheres(scene), {size, state.shown_background(), true, samples, state.settings.shading},
                       timings, facts, progress);
    write_output(path, encode_png(picture));
}

void export_now(ViewerState& state) {
    const std::string fault = try_export(state, next_free_name(state).string(), export_size(state));
    if (!fault.empty()) report_error(state, "The picture cannot be exported", fault);
}

void ask_for_export(ViewerState& state) { ask_for_export(state, next_free_name(state).string(), ""); }

}  // namespace sphereview

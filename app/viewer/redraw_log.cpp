#include "viewer/redraw_log.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "app/json.hpp"
#include "base/error.hpp"
#include "base/standard_streams.hpp"

namespace sphereview {

namespace {

Json vector(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

// A million numbers would make each line one of megabytes.
std::vector<std::uint32_t> first_of(const std::vector<std::uint32_t>& numbers) {
    constexpr std::size_t most = 1000;
    return {numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(std::min(most, numbers.size()))};
}

}  // namespace

RedrawLog::RedrawLog(const std::string& path) : file_(nullptr, std::fclose) {
    if (path.empty()) return;
    file_.reset(open_file(path, "w"));
    if (!file_) throw OutputError(path, std::strerror(errno), errno);
}

void RedrawLog::add(const ViewerState& state, const RedrawFacts& facts, const LoggedRedraw& frame,
                    const WidgetRectangles& widgets) {
    if (!file_) return;
    Json rectangles = Json::object();
    for (const auto& [name, r] : widgets) rectangles.set(name, {r.left, r.top, r.right, r.bottom});
    Json dialogs = Json::array();
    for (const Dialog& dialog : state.dialogs) dialogs.push_back(id_of(dialog));
    const Rectangle& p = frame.picture;
    const Camera& camera = state.camera;
    const Json line = {
        {"frame", frame.number},
        {"revision", state.document.revision()},
        {"step", facts.status.step},
        {"builds", frame.builds},
        {"explanations", frame.explanations},
        {"exact", frame.exact},
        {"draft", frame.draft},
        {"samples", frame.exact ? state.settings.samples : 1},
        {"shading", name_of(state.settings.shading)},
        {"making", frame.making},
        {"resting", frame.resting},
        {"seconds", frame.seconds},
        {"title", frame.title},
        {"renderer", facts.status.renderer},
        {"path", state.path},
        {"scene_frame", {state.frame, state.frames}},
        {"changed", state.document.is_changed()},
        {"spheres", state.scene().spheres.size()},
        {"selection", first_of(state.selection.numbers())},
        {"selected", state.selection.size()},
        {"hovered", state.hovered},
        {"measured", first_of(state.measuring.spheres)},
        {"undo", state.document.undo_name()},
        {"redo", state.document.redo_name()},
        {"picture", {p.x, p.y, p.width, p.height}},
        {"picture_size", {state.picture_size.width, state.picture_size.height}},
        {"camera", {vector(camera.eye), vector(camera.center), vector(camera.right), vector(camera.up)}},
        {"projection", name_of(camera.projection)},
        {"dialogs", dialogs},
        {"shown",
         {{"panel", state.panel_shown},
          {"inspector", state.inspector_shown},
          {"export area", state.export_area_shown},
          {"help", state.help_shown}}},
        {"loading", state.messages.work && state.loading ? Json(state.messages.work->fraction.value_or(0.0)) : Json(nullptr)},
        {"saving", state.saving.has_value()},
        {"exporting", state.exporting ? Json(state.exporting->shown_path()) : Json(nullptr)},
        {"announcement", state.messages.announcement},
        {"scene_error", state.messages.scene_error},
        {"shader_error", state.messages.shader_error},
        {"widgets", rectangles}};
    const std::string text = line.dump() + "\n";
    std::fwrite(text.data(), 1, text.size(), file_.get());
    std::fflush(file_.get());
}

}  // namespace sphereview

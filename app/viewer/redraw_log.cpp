#include "viewer/redraw_log.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "app/json.hpp"
#include "base/error.hpp"
#include "base/standard_streams.hpp"
#include "base/text.hpp"
#include "camera/navigation.hpp"

namespace sphereview {

namespace {

Json vector(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

// A million numbers would make each line one of megabytes.
std::vector<std::uint32_t> first_of(const std::vector<std::uint32_t>& numbers) {
    constexpr std::size_t most = 1000;
    return {numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(std::min(most, numbers.size()))};
}

Json pixel_of(const std::optional<InspectedPixel>& inspected) {
    return inspected ? Json{inspected->place.pixel.x, inspected->place.pixel.y} : Json(nullptr);
}

// What the inspector shows.
Json inspected(const Inspection& inspection) {
    if (!inspection.first) return nullptr;
    const PictureSize size = inspection.first->place.size;
    return {{"pixel", pixel_of(inspection.first)},
            {"size", {size.width, size.height}},
            {"pinned", inspection.pinned},
            {"second", pixel_of(inspection.second)},
            {"visible", inspection.first->explanation.visible()}};
}

// An eye that is seen from beside, with its rays.
Json rays_of(const ViewerState& state, const std::optional<InspectedPixel>& inspected) {
    const RaysInSpace& rays = state.rays;
    if (!rays.on) return nullptr;
    const auto& made = rays.rays.made();
    const auto is_hit = [](const TracedRay& ray) { return ray.visible >= 0; };
    Json end = nullptr;  // where the picture shows the end of the single ray
    if (inspected && !inspected->explanation.hits.empty()) {
        const auto place = place_of(state.camera, state.picture_size, inspected->explanation.hits.front().point);
        if (place) end = {place->x, place->y};
    }
    return {{"eye", vector(rays.camera.eye)},
            {"size", {rays.size.width, rays.size.height}},
            {"screen", rays.screen_depth},
            {"every", rays.choice.every()},
            {"rays", made ? made->size() : 0},
            {"hits", made ? std::ranges::count_if(*made, is_hit) : 0},
            {"end", end},
            {"picture", rays.picture.made() != nullptr}};
}

}  // namespace

RedrawLog::RedrawLog(const std::string& path) : file_(nullptr, std::fclose) {
    if (path.empty()) return;
    file_.reset(open_file(path, "w"));
    if (!file_) throw OutputError(path, std::strerror(errno), errno);
}

void RedrawLog::add(const ViewerState& state, const RedrawFacts& facts, const LoggedRedraw& redraw,
                    const WidgetRectangles& widgets) {
    if (!file_) return;
    Json rectangles = Json::object();
    for (const auto& [name, r] : widgets) rectangles.set(name, {r.left, r.top, r.right, r.bottom});
    Json dialogs = Json::array();
    for (const Dialog& dialog : state.dialogs) dialogs.push_back(id_of(dialog));
    const Rectangle& p = redraw.picture;
    const Camera& camera = state.camera;
    const Json line = {
        {"redraw", redraw.number},
        {"revision", state.document.revision()},
        {"step", facts.status.step},
        {"builds", redraw.builds},
        {"explanations", redraw.explanations},
        {"exact", redraw.exact},
        {"draft", redraw.draft},
        {"samples", redraw.exact ? state.settings.samples : 1},
        {"shading", name_of(state.settings.shading)},
        {"making", redraw.making},
        {"resting", redraw.resting},
        {"seconds", redraw.seconds},
        {"title", redraw.title},
        {"renderer", facts.status.renderer},
        {"path", state.path},
        {"frame", {state.frame, state.frames}},
        {"playing", state.player.clock.plays()},
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
        {"inspected", inspected(facts.inspection)},
        {"rays", rays_of(state, facts.inspection.first)},
        {"comparison", state.comparison ? Json(joined(state.comparison->words.verdict, "; ")) : Json(nullptr)},
        {"camera", {vector(camera.eye), vector(camera.center), vector(camera.right), vector(camera.up)}},
        {"projection", name_of(camera.projection)},
        {"dialogs", dialogs},
        {"shown",
         {{"panel", state.panel_shown},
          {"inspector", state.inspector_shown},
          {"export area", state.export_area_shown},
          {"rays", state.rays.on},
          {"help", state.help_shown}}},
        {"loading", state.messages.work && state.loading ? Json(state.messages.work->fraction.value_or(0.0)) : Json(nullptr)},
        {"saving", state.saving.has_value()},
        {"exporting", state.exporting ? Json(state.exporting->shown_path()) : Json(nullptr)},
        {"filming", state.filming ? Json(state.filming->path) : Json(nullptr)},
        {"announcement", state.messages.announcement},
        {"scene_error", state.messages.scene_error},
        {"shader_error", state.messages.shader_error},
        {"widgets", rectangles}};
    const std::string text = line.dump() + "\n";
    std::fwrite(text.data(), 1, text.size(), file_.get());
    std::fflush(file_.get());
}

}  // namespace sphereview

#include "viewer/settings.hpp"

#include <exception>
#include <filesystem>
#include <optional>
#include <system_error>
#include <type_traits>

#include "app/json.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/path.hpp"
#include "base/user_folders.hpp"
#include "image/image.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

fs::path settings_file() {
    const fs::path folder = config_folder();
    return folder.empty() ? fs::path() : folder / "viewer.json";
}

// An empty object where there is no file, or none with an object; `fault` says why.
Json read_file(const fs::path& file, std::string& fault) {
    std::error_code ignored;
    if (file.empty() || !fs::is_regular_file(file, ignored)) return Json::object();
    try {
        Json json = Json::parse(InputFile(text_from(file)).bytes(), text_from(file));
        if (json.is_object()) return json;
        fault = text_from(file) + ":1:1: this is not a JSON object";
    } catch (const std::exception& error) {
        fault = error.what();
    }
    return Json::object();
}

template <typename T>
void read(const Json& json, const char* key, SettingRange<T> range, auto& setting) {
    // A double holds every range.
    const auto whole = json[key].whole();
    const auto number = std::is_integral_v<T> && !whole ? std::nullopt : json[key].number();
    if (number && *number >= range.least && *number <= range.most) setting = static_cast<T>(*number);
}

// Every number with its key and its range, for reading and for writing.
template <typename Settings, typename Visit>
void each_number(Settings& settings, const Visit& visit) {
    visit("panel_width", settings.panel_width, panel_width_range);
    visit("inspector_width", settings.inspector_width, inspector_width_range);
    visit("text_scale", settings.text_scale, text_scale_range);
    visit("export_width", settings.export_width, export_side_range);
    visit("export_height", settings.export_height, export_side_range);
    visit("film_width", settings.film_width, export_side_range);
    visit("film_height", settings.film_height, export_side_range);
    visit("samples", settings.samples, SettingRange<int>{sample_counts.front(), sample_counts.back()});
}

// Every switch with its key.
template <typename Settings, typename Visit>
void each_switch(Settings& settings, const Visit& visit) {
    visit("trackball", settings.trackball);
    visit("light_theme", settings.light_theme);
    visit("axes", settings.axes_shown);
    visit("scale_bar", settings.scale_bar_shown);
    visit("legend", settings.legend_shown);
    visit("marks_in_exports", settings.marks_exported);
}

void read_place(const Json& json, WindowPlace& place) {
    const Json window = json["window"];
    read(window, "x", window_place_range, place.x);
    read(window, "y", window_place_range, place.y);
    if (!place.x || !place.y) place.x = place.y = std::nullopt;  // half a place is none
    read(window, "width", window_side_range, place.width);
    read(window, "height", window_side_range, place.height);
    place.maximized = window["maximized"].boolean().value_or(place.maximized);
}

void read_recent(const Json& json, std::vector<std::string>& recent) {
    constexpr std::size_t longest_path = 32'768;  // bytes; no system opens a longer one, and its parts would take seconds
    for (const Json& entry : json["recent"].list()) {
        const auto path = entry.text();
        if (!path || path->size() > longest_path || recent.size() == most_recent) continue;
        const fs::path file = path_from(*path);
        const bool whole = file.is_absolute() || is_network_name(file);
        if (whole && std::ranges::find(recent, *path) == recent.end()) recent.push_back(*path);
    }
}

// Changes only these settings in the file's JSON.
void update(Json& json, const ViewerSettings& settings) {
    Json window = json["window"];
    if (!window.is_object()) window = Json::object();
    window.erase("x");
    window.erase("y");
    if (settings.place.x && settings.place.y) {
        window.set("x", *settings.place.x);
        window.set("y", *settings.place.y);
    }
    window.set("width", settings.place.width);
    window.set("height", settings.place.height);
    window.set("maximized", settings.place.maximized);
    json.set("window", window);
    each_number(settings, [&](const char* key, auto value, auto) { json.set(key, value); });
    each_switch(settings, [&](const char* key, bool on) { json.set(key, on); });
    json.set("shading", name_of(settings.shading));
    Json recent = Json::array();
    for (const std::string& path : settings.recent) {
        if (is_utf8(path)) recent.push_back(path);
    }
    json.set("recent", recent);
}

}  // namespace

std::string absolute_path(const std::string& path) {
    std::error_code error;
    const fs::path given = path_from(path);
    const fs::path full = is_network_name(given) ? given : fs::absolute(given, error);
    return error ? path : text_from(normal_path(full));
}

void add_recent(ViewerSettings& settings, const std::string& path) {
    const std::string full = absolute_path(path);
    std::erase(settings.recent, full);
    settings.recent.insert(settings.recent.begin(), full);
    if (settings.recent.size() > most_recent) settings.recent.resize(most_recent);
}

void remove_recent(ViewerSettings& settings, const std::string& path) { std::erase(settings.recent, absolute_path(path)); }

ViewerSettings load_settings(std::string* fault) {
    std::string unreadable;
    const Json json = read_file(settings_file(), unreadable);
    if (fault != nullptr) *fault = unreadable;
    ViewerSettings settings;
    read_place(json, settings.place);
    each_number(settings, [&](const char* key, auto& setting, auto range) { read(json, key, range, setting); });
    each_switch(settings, [&](const char* key, bool& on) { on = json[key].boolean().value_or(on); });
    const auto keep_possible = [](int& width, int& height, int usual_width, int usual_height) {
        if (std::int64_t{width} * height <= most_pixels) return;
        width = usual_width;
        height = usual_height;
    };
    const ViewerSettings usual;
    keep_possible(settings.export_width, settings.export_height, usual.export_width, usual.export_height);
    keep_possible(settings.film_width, settings.film_height, usual.film_width, usual.film_height);
    if (std::ranges::find(sample_counts, settings.samples) == sample_counts.end()) settings.samples = ViewerSettings{}.samples;
    if (const auto name = json["shading"].text()) settings.shading = shading_named(*name).value_or(settings.shading);
    read_recent(json, settings.recent);
    return settings;
}

bool save_settings(const ViewerSettings& settings) noexcept {
    try {
        const fs::path file = settings_file();
        if (file.empty() || !make_user_folder(file.parent_path())) return false;
        std::string ignored;
        Json json = read_file(file, ignored);
        update(json, settings);
        write_regular_file(text_from(file), json.dump(4) + "\n");
        return true;
    } catch (const std::exception&) {
        return false;
    }
}

}  // namespace sphereview

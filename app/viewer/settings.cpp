#include "viewer/settings.hpp"

#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/user_folders.hpp"
#include "image/image.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

fs::path settings_file() {
    const fs::path folder = config_folder();
    return folder.empty() ? fs::path() : folder / "viewer.json";
}

// An empty object where there is no file, or none with an object.
Json read_file(const fs::path& file) {
    std::error_code ignored;
    if (file.empty() || !fs::is_regular_file(file, ignored)) return Json::object();
    try {
        Json json = Json::parse(InputFile(file.string()).bytes(), nullptr, false);
        if (json.is_object()) return json;
    } catch (const std::exception&) {
        // An unreadable file counts as none.
    }
    return Json::object();
}

template <typename T>
void read(const Json& json, const char* key, SettingRange<T> range, auto& setting) {
    const auto value = json.find(key);
    if (value == json.end() || !(std::is_integral_v<T> ? value->is_number_integer() : value->is_number())) return;
    // As a double, which holds all of every range, and of an integer beyond 64 bits how large it is.
    const auto number = value->get<double>();
    if (number >= range.least && number <= range.most) setting = static_cast<T>(number);
}

// Every number with its key and its range, for reading and for writing.
template <typename Settings, typename Visit>
void each_number(Settings& settings, const Visit& visit) {
    visit("panel_width", settings.panel_width, panel_width_range);
    visit("text_scale", settings.text_scale, text_scale_range);
    visit("export_width", settings.export_width, export_side_range);
    visit("export_height", settings.export_height, export_side_range);
    visit("samples", settings.samples, SettingRange<int>{sample_counts.front(), sample_counts.back()});
}

void read_place(const Json& json, WindowPlace& place) {
    const auto window = json.find("window");
    if (window == json.end() || !window->is_object()) return;
    read(*window, "x", window_place_range, place.x);
    read(*window, "y", window_place_range, place.y);
    if (!place.x || !place.y) place.x = place.y = std::nullopt;  // half a place is none
    read(*window, "width", window_side_range, place.width);
    read(*window, "height", window_side_range, place.height);
    const auto maximized = window->find("maximized");
    if (maximized != window->end() && maximized->is_boolean()) place.maximized = maximized->get<bool>();
}

void read_recent(const Json& json, std::vector<std::string>& recent) {
    const auto list = json.find("recent");
    if (list == json.end() || !list->is_array()) return;
    for (const Json& entry : *list) {
        if (!entry.is_string() || recent.size() == most_recent) continue;
        const auto path = entry.get<std::string>();
        if (fs::path(path).is_absolute() && std::ranges::find(recent, path) == recent.end()) recent.push_back(path);
    }
}

bool is_utf8(const std::string& text) {
    try {
        static_cast<void>(Json(text).dump());
        return true;
    } catch (const Json::exception&) {
        return false;
    }
}

// Of what is there already, only these settings change.
void update(Json& json, const ViewerSettings& settings) {
    Json& window = json["window"];
    if (!window.is_object()) window = Json::object();
    window.erase("x");
    window.erase("y");
    if (settings.place.x && settings.place.y) {
        window["x"] = *settings.place.x;
        window["y"] = *settings.place.y;
    }
    window["width"] = settings.place.width;
    window["height"] = settings.place.height;
    window["maximized"] = settings.place.maximized;
    each_number(settings, [&](const char* key, auto value, auto) { json[key] = value; });
    json["shading"] = name_of(settings.shading);
    Json recent = Json::array();
    std::ranges::copy_if(settings.recent, std::back_inserter(recent), is_utf8);
    json["recent"] = recent;
}

std::string absolute(const std::string& path) {
    std::error_code error;
    const fs::path full = fs::absolute(path, error).lexically_normal();
    return error ? path : full.string();
}

}  // namespace

void add_recent(ViewerSettings& settings, const std::string& path) {
    const std::string full = absolute(path);
    std::erase(settings.recent, full);
    settings.recent.insert(settings.recent.begin(), full);
    if (settings.recent.size() > most_recent) settings.recent.resize(most_recent);
}

void remove_recent(ViewerSettings& settings, const std::string& path) { std::erase(settings.recent, absolute(path)); }

ViewerSettings load_settings() {
    const Json json = read_file(settings_file());
    ViewerSettings settings;
    read_place(json, settings.place);
    each_number(settings, [&](const char* key, auto& setting, auto range) { read(json, key, range, setting); });
    if (std::int64_t{settings.export_width} * settings.export_height > most_pixels) {
        settings.export_width = ViewerSettings{}.export_width;
        settings.export_height = ViewerSettings{}.export_height;
    }
    if (std::ranges::find(sample_counts, settings.samples) == sample_counts.end()) settings.samples = ViewerSettings{}.samples;
    const auto shading = json.find("shading");
    if (shading != json.end() && shading->is_string()) {
        settings.shading = shading_named(shading->get<std::string>()).value_or(settings.shading);
    }
    read_recent(json, settings.recent);
    return settings;
}

bool save_settings(const ViewerSettings& settings) noexcept {
    try {
        const fs::path file = settings_file();
        if (file.empty() || !make_user_folder(file.parent_path())) return false;
        Json json = read_file(file);
        update(json, settings);
        write_output(file.string(), json.dump(4) + "\n");
        return true;
    } catch (const std::exception&) {
        return false;
    }
}

}  // namespace sphereview

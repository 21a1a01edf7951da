// The viewer's settings, kept from run to run in base/user_folders.hpp's config_folder().
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "platform/window.hpp"
#include "scene/camera.hpp"
#include "shade/shading.hpp"

namespace sphereview {

// The range of a setting. A value of the file beyond it is ignored.
template <typename T>
struct SettingRange {
    T least;
    T most;

    constexpr T nearest(T value) const { return std::clamp(value, least, most); }
};
inline constexpr SettingRange<int> window_side_range{100, 32767};  // screen coordinates
inline constexpr SettingRange<int> window_place_range{-32768, 32767};
inline constexpr SettingRange<double> panel_width_range{220.0, 4000.0};
inline constexpr SettingRange<double> inspector_width_range{260.0, 4000.0};
inline constexpr SettingRange<double> text_scale_range{0.5, 4.0};
inline constexpr SettingRange<int> export_side_range{1, 65535};  // both together: at most `most_pixels`
inline constexpr std::size_t most_recent = 10;

struct ViewerSettings {
    WindowPlace place;
    double panel_width = 360.0;       // screen coordinates
    double inspector_width = 400.0;   // likewise
    double text_scale = 1.0;          // factor beside the system's
    std::vector<std::string> recent;  // absolute paths, the latest first, each once, at most `most_recent`
    int export_width = 1000;
    int export_height = 1000;
    int film_width = 1000;
    int film_height = 1000;
    int samples = sample_counts.back();  // points a pixel, of the window at rest and of exports: one of sample_counts
    Shading shading = Shading::studio;
    bool trackball = false;  // a drag turns the view without an upright
    bool light_theme = false;
    bool axes_shown = true;
    bool scale_bar_shown = false;
    bool legend_shown = true;     // where colours stand for values
    bool marks_exported = false;  // draws what is shown of these three into exports

    bool operator==(const ViewerSettings&) const = default;
};

// The path from the root, without . and ..; unchanged where the system names no current folder.
std::string absolute_path(const std::string& path);

// Makes the path, as an absolute one, the latest.
void add_recent(ViewerSettings& settings, const std::string& path);
void remove_recent(ViewerSettings& settings, const std::string& path);

// The settings that were saved last; the default for each that is missing, broken or out of its range. `fault` gets the message
// "FILE:LINE:COLUMN: ..." for a file that cannot be read at all.
ViewerSettings load_settings(std::string* fault = nullptr);

// False on failure. Keeps other versions' settings in the same file. Leaves out paths that are not UTF-8, which JSON cannot hold.
bool save_settings(const ViewerSettings& settings) noexcept;

}  // namespace sphereview

// What the viewer keeps from one run to the next, in the platform's folder for settings.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "platform/window.hpp"
#include "scene/camera.hpp"
#include "shade/shading.hpp"

namespace sphereview {

// What a setting may be; a file that says otherwise is not believed.
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
    double text_scale = 1.0;          // times what the system wants
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
    bool legend_shown = true;     // of colours that stand for something
    bool marks_exported = false;  // what is shown of these three

    bool operator==(const ViewerSettings&) const = default;
};

// The path from the root, without . and ..; as it is where the system names no current folder.
std::string absolute_path(const std::string& path);

// The path, made absolute, becomes the latest.
void add_recent(ViewerSettings& settings, const std::string& path);
void remove_recent(ViewerSettings& settings, const std::string& path);

// What was saved last; the default for each setting that is missing, broken or out of its range. `fault` gets what is wrong with a
// file that cannot be read at all: "FILE:LINE:COLUMN: what was found".
ViewerSettings load_settings(std::string* fault = nullptr);

// Returns false when that cannot be done. What another version of the program keeps in the same file stays. A path that is not
// UTF-8 is left out: JSON cannot hold it.
bool save_settings(const ViewerSettings& settings) noexcept;

}  // namespace sphereview

// What the window keeps from one run to the next. Other programs and people may have changed it.
#include <cstdlib>

#include "base/error.hpp"
#include "formats/scene_format.hpp"
#include "fuzz/targets.hpp"
#include "support/temporary_folder.hpp"
#include "viewer/recovery.hpp"
#include "viewer/settings.hpp"

namespace sphereview {

namespace {

// The user's folders of this process: the fuzzer's own settings are not to be touched.
const test::TemporaryFolder& home() {
    static const test::TemporaryFolder folder;
    static const bool is_set = [] {
        setenv("XDG_CONFIG_HOME", folder.path("config").c_str(), 1);
        setenv("XDG_STATE_HOME", folder.path("state").c_str(), 1);
        return true;
    }();
    static_cast<void>(is_set);
    return folder;
}

bool are_same(const ViewerSettings& a, const ViewerSettings& b) {
    return a.place.x == b.place.x && a.place.y == b.place.y && a.place.width == b.place.width && a.place.height == b.place.height &&
           a.place.maximized == b.place.maximized && a.panel_width == b.panel_width && a.text_scale == b.text_scale &&
           a.recent == b.recent && a.export_width == b.export_width && a.export_height == b.export_height &&
           a.film_width == b.film_width && a.film_height == b.film_height && a.samples == b.samples && a.shading == b.shading;
}

}  // namespace

std::string fuzz_settings(std::string_view bytes) {
    home().write("config/sphereview/viewer.json", bytes);
    const ViewerSettings settings = load_settings();
    if (settings.recent.size() > most_recent) return "too many recent files";
    if (panel_width_range.nearest(settings.panel_width) != settings.panel_width) return "a panel of a width beyond its range";
    if (!save_settings(settings)) return "the settings cannot be saved";
    return are_same(load_settings(), settings) ? "" : "the settings are others after they were saved";
}

std::string fuzz_recovery(std::string_view bytes) {
    home().write("state/sphereview/recovery-1.toml", bytes);
    for (const Recovery& recovery : list_recoveries()) {
        try {
            parse_scene(bytes, recovery.file);
        } catch (const InputError&) {
            // The window says so, and leaves the file where it is.
        } catch (const MemoryError&) {
            // Likewise.
        }
        if (!remove_recovery(recovery.file)) return "the recovery cannot be removed";
    }
    return "";
}

}  // namespace sphereview

// From a path to a scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/look.hpp"
#include "base/background_job.hpp"
#include "base/progress.hpp"
#include "camera/fit.hpp"
#include "formats/scene_format.hpp"
#include "formats/sphere_data.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// A scene and how messages call the file it came from.
struct LoadedScene : SphereData {
    std::string name{};
    SceneFormat format = SceneFormat::text;
    bool all_frames = true;              // else there may be more than `frames` (LoadOptions::counts_frames)
    AppliedLook look{};                  // what the options' look has made of it
    bool fitted = false;                 // its camera was moved to see everything
    std::optional<glm::dvec3> middle{};  // of all frames that one camera shows; none: the scene's own

    // Whether its camera is its own; else nobody has chosen one, and it is fitted unless that is forbidden.
    bool has_camera() const { return !format.is_data; }
};

// From where a scene is seen, if not by its own camera.
struct FitOptions {
    std::optional<bool> wanted{};             // to everything; none: only if nobody has chosen the scene's camera
    std::optional<ViewAxes> view{};           // none: the way that the scene's camera looks
    std::optional<Projection> projection{};   // instead of the camera's
    std::optional<std::string> saved_view{};  // by the camera of the scene's view of that name, not fitted
    std::optional<std::string> camera{};      // by the camera of this scene, or its view of that name; not fitted
    std::optional<Camera> given{};            // by this camera alone; not fitted
};

// What `--view TEXT` asks for: a side, an azimuth and an elevation, or else a saved view; nothing for what none can be called.
std::optional<FitOptions> fit_from(const std::string& view);

struct LoadOptions {
    Progress* progress = nullptr;
    std::size_t more_per_sphere = 0;  // bytes that are needed for what is to be made of it
    DataOptions data{};
    LookOptions look{};
    FitOptions fit{};
    std::optional<Background> data_background{};  // of a scene from another program's file, which names none
    WorkControl* control = nullptr;               // told the bytes that were read, and looked at while reading
    bool counts_frames = true;  // else a large file is read no farther than the frame needs, where its format allows that
};

// The camera of the scene's view of that name. Throws InputError where there is none.
Camera saved_view(const LoadedScene& loaded, const std::string& name);

// By which camera a scene is seen that is not fitted, or before it is. Throws InputError, also where FitOptions::camera has none.
Camera chosen_camera(const LoadedScene& loaded, const FitOptions& fit);

// Whether the camera is moved to see everything.
bool is_to_fit(const LoadedScene& loaded, const FitOptions& fit);

// Gives what was read the background, the look and the camera that the options ask for. Throws InputError.
void complete(LoadedScene& loaded, const LoadOptions& options);

// Reads a scene file of any format, or standard input for "-"; of a text, only a small part is in memory at a time. Throws
// InputError, also for a saved view or a property that the scene has not, MemoryError when it cannot fit, and Cancelled.
LoadedScene load_scene(const std::string& path, const LoadOptions& options = {});

// Throws InputError where the scene has not all the properties that were asked for by name.
void require_properties(const LoadedScene& loaded, const DataOptions& asked);

// Says the warnings and what the look has chosen on stderr, a line each.
void say_warnings(const LoadedScene& loaded);

}  // namespace sphereview

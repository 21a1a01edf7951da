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

// A scene, with what else was read of its file.
struct LoadedScene : SphereData {
    std::string name{};
    SceneFormat format = SceneFormat::text;
    bool all_frames = true;              // false: there may be more than `frames` (LoadOptions::counts_frames)
    AppliedLook look{};                  // the result of the options' look
    bool fitted = false;                 // the camera was moved to see everything
    std::optional<glm::dvec3> middle{};  // of all frames that share a camera; none: the scene's own

    // Whether the file has a camera. Without one the camera is fitted, unless that is forbidden.
    bool has_camera() const { return !format.is_data; }
};

// The camera by which a scene is seen, instead of its own.
struct FitOptions {
    std::optional<bool> wanted{};             // whether to fit; none: only a scene without a camera
    std::optional<ViewAxes> view{};           // the direction of a fit; none: as the scene's camera looks
    std::optional<Projection> projection{};   // instead of the camera's
    std::optional<std::string> saved_view{};  // the name of a saved view to use, not fitted
    std::optional<std::string> camera{};      // a scene whose camera, or saved view, is used; not fitted
    std::optional<Camera> given{};            // the camera to use, not fitted
};

// The options of `--view TEXT`: a side, an azimuth and an elevation, or else a saved view. Nothing for a text that cannot be a
// view's name.
std::optional<FitOptions> fit_from(const std::string& view);

struct LoadOptions {
    Progress* progress = nullptr;
    std::size_t more_per_sphere = 0;  // bytes that the caller will need besides
    DataOptions data{};
    LookOptions look{};
    FitOptions fit{};
    std::optional<Background> data_background{};  // of data, which names none
    WorkControl* control = nullptr;               // gets the bytes read, and may cancel
    bool counts_frames = true;                    // false: reads no more of a large file than the frame needs, if possible
};

// The camera of the scene's view of that name. Throws InputError where there is none.
Camera saved_view(const LoadedScene& loaded, const std::string& name);

// The camera that `fit` chooses, before any fitting. Throws InputError, also where FitOptions::camera has no camera.
Camera chosen_camera(const LoadedScene& loaded, const FitOptions& fit);

// Whether the camera is to be fitted.
bool is_to_fit(const LoadedScene& loaded, const FitOptions& fit);

// Gives a scene that was read the options' background, look and camera. Throws InputError.
void complete(LoadedScene& loaded, const LoadOptions& options);

// Reads a scene file of any format, or standard input for "-"; only a small part of a text is in memory at a time. Throws
// InputError, also for a saved view or a property that the scene lacks, MemoryError when the scene cannot fit, and Cancelled.
LoadedScene load_scene(const std::string& path, const LoadOptions& options = {});

// Throws InputError if the scene lacks a property that was asked for by name.
void require_properties(const LoadedScene& loaded, const DataOptions& asked);

// Prints the warnings and the look's choices on stderr, a line each.
void say_warnings(const LoadedScene& loaded);

}  // namespace sphereview

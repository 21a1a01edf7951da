// From a path to a scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/background_job.hpp"
#include "base/progress.hpp"
#include "camera/fit.hpp"
#include "formats/scene_format.hpp"
#include "formats/sphere_data.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// A scene and how messages call the file it came from.
struct LoadedScene {
    Scene scene{};
    std::string name{};
    SceneFormat format = SceneFormat::text;
    std::int64_t frames = 1;              // in the file
    std::vector<std::string> warnings{};  // as of SphereData
    std::vector<std::string> notes{};
    bool fitted = false;  // its camera was moved to see everything

    // Whether its camera is its own; else nobody has chosen one, and it is fitted unless that is forbidden.
    bool has_camera() const { return !format.is_data; }
};

// From where a scene is seen, if not by its own camera.
struct FitOptions {
    std::optional<bool> wanted{};            // to everything; none: only if nobody has chosen the scene's camera
    std::optional<ViewAxes> view{};          // none: the way that the scene's camera looks
    std::optional<Projection> projection{};  // instead of the camera's
};

struct LoadOptions {
    Progress* progress = nullptr;
    std::size_t more_per_sphere = 0;  // bytes that are needed for what is to be made of it
    DataOptions data{};
    FitOptions fit{};
    std::optional<Background> data_background{};  // of a scene from another program's file, which names none
    WorkControl* control = nullptr;               // told the bytes that were read, and looked at while reading
};

// Reads a scene file of any format, or standard input for "-"; of a text, only a small part is in memory at a time. Throws
// InputError, MemoryError when it cannot fit, and Cancelled.
LoadedScene load_scene(const std::string& path, const LoadOptions& options = {});

// Writes a line to standard error for each of `lines`, which begins with the scene's name.
void say_of(const LoadedScene& scene, const std::vector<std::string>& lines);

}  // namespace sphereview

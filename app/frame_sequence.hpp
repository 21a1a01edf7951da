// The pictures of a trajectory's frames, or around a scene, by one camera that only turns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/load_scene.hpp"
#include "app/options.hpp"
#include "base/progress.hpp"
#include "camera/turntable.hpp"
#include "formats/frame_reader.hpp"

namespace sphereview {

// One picture of them.
struct Shot {
    std::int64_t number = 0;  // for names: the frame's, or of several pictures of one frame that of the picture
    std::int64_t frame = 0;
    double degrees = 0.0;  // that the camera has turned
};

class FrameSequence {
public:
    // Opens the file and finds the frames that `options` ask for, which must outlive this. Throws InputError.
    FrameSequence(const std::string& path, const RenderOptions& options, Progress& progress);

    const std::vector<Shot>& shots() const { return shots_; }

    // Chooses the camera; before load(). Where it is fitted, all frames are read once. Throws as load_scene().
    void prepare(Progress& progress);

    // The scene of a shot as the camera sees it then. Its light stays where it is in the scene while the camera turns.
    LoadedScene load(const Shot& shot);

    // Says those warnings on stderr that no frame had before.
    void say_warnings(const LoadedScene& loaded);

private:
    // A frame as the file has it.
    const LoadedScene& read(std::int64_t frame);
    Camera fitted_camera(const LoadedScene& first, const ViewAxes& axes, Progress& progress);

    const RenderOptions& options_;
    LookOptions look_;  // with what the first frame's values gave
    FrameReader reader_;
    std::vector<Shot> shots_{};
    LoadedScene present_{};  // the frame that was read last
    std::int64_t present_frame_ = -1;
    Camera camera_{};
    bool fitted_ = false;
    std::optional<Turn> turn_{};
    glm::dvec3 middle_{0.0};  // of what the camera is fitted to, or of the first frame
    std::set<std::string> said_{};
};

}  // namespace sphereview

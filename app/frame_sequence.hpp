// The pictures of a trajectory's frames, or around a scene, by one camera, which may turn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/frame_changes.hpp"
#include "app/load_scene.hpp"
#include "app/options.hpp"
#include "base/progress.hpp"
#include "camera/turntable.hpp"
#include "formats/frame_reader.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

// One picture of a sequence.
struct Shot {
    std::int64_t number = 0;  // for names: the frame's, or the picture's if all are of one frame
    std::int64_t frame = 0;
    double degrees = 0.0;  // that the camera has turned
};

// The shots of these frames, one each; of a single frame with a turntable, all around it. `turntable`: pictures of a whole turn; 0:
// none.
std::vector<Shot> shots_of(const std::vector<std::int64_t>& frames, std::int64_t turntable);

class FrameSequence {
public:
    // Opens the file and finds the frames that `options` ask for. `options` must outlive this object. Throws InputError.
    FrameSequence(const std::string& path, const RenderOptions& options, Progress& progress);
    // A turntable around a scene that is read already. `options` must outlive this object.
    FrameSequence(LoadedScene scene, const RenderOptions& options);

    // Applies these changes to every frame. Call before prepare().
    void set_changes(FrameChanges changes) { changes_ = std::move(changes); }
    // In words, what is passed over where the file is cut off or wrong behind a frame; else "".
    const std::string& early_end() const { return early_end_; }
    // Whether frames may be lost: more text follows the fault, or a frame up to the last wanted one is cut off and others follow.
    bool is_damaged() const { return is_damaged_; }

    const std::vector<Shot>& shots() const { return shots_; }

    // Chooses the camera; call before load(). To fit the camera, reads all frames once. Faults of frames other than the first are
    // left to load(), unless a film is made. Throws as load_scene().
    void prepare(Progress& progress);

    // The SHA-256 of all that this shot's picture takes from the other shots: the camera, ranges, the radius of points. After
    // prepare().
    std::string sum_of(const Shot& shot) const;

    // The scene of a shot, with the shot's camera. Its light stays fixed to the scene while the camera turns.
    LoadedScene load(const Shot& shot);

    // For people: which loaded frames hold values beyond the range of colours, which is the first frame's; "" where none does.
    std::string values_beyond_range() const;

    // The lines that no earlier call of this returned.
    std::vector<std::string> not_said(const std::vector<std::string>& lines);

private:
    // A frame of the file, with the radius of points, range, scale and order of categories that all frames share. Each comes from
    // the first frame in the list that has one, whichever is read first, so all parts of the list have the same.
    const LoadedScene& read(std::int64_t frame);
    SphereData read_data(std::int64_t frame);
    void read_alone(std::int64_t frame);
    template <typename IsIt>
    void look_through(const IsIt& is_it);
    // A hash of all that the fitted camera depends on besides the file; nothing where the options cannot say all of that.
    std::optional<std::string> question_of_fit(const ViewAxes& axes) const;
    const LoadedScene* read_to_fit(std::int64_t frame);
    Camera fitted_camera(const LoadedScene& first, const ViewAxes& axes, Progress& progress);
    Camera camera_of(const Shot& shot) const { return turn_ ? turn_->camera(camera_, middle_, shot.degrees) : camera_; }

    const RenderOptions& options_;
    LookOptions look_;  // completed by the first frame's values
    // Whether each is known, or not needed.
    bool knows_radius_ = false;
    bool knows_range_ = false;
    bool knows_scale_ = false;
    bool knows_order_ = false;
    std::optional<FrameReader> reader_{};  // none: the one frame is `present_`
    FrameChanges changes_{};
    std::string early_end_{};
    bool is_damaged_ = false;
    std::vector<Shot> shots_{};
    LoadedScene present_{};  // the frame that was read last
    std::int64_t present_frame_ = -1;
    Camera camera_{};
    bool fitted_ = false;
    std::optional<Turn> turn_{};
    std::string shared_{};    // the beginning of sum_of()'s text, the same for all shots
    glm::dvec3 middle_{0.0};  // of all that the camera is fitted to, or of the first frame
    std::set<std::string> said_{};
    std::set<std::int64_t> beyond_range_{};       // frames
    std::optional<double> radius_{};              // of points, from the first frame that has one
    std::vector<std::string> radius_warnings_{};  // of that frame, until a picture reports them
};

}  // namespace sphereview

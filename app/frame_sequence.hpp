// The pictures of a trajectory's frames, or around a scene, by one camera that only turns.
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

// One picture of them.
struct Shot {
    std::int64_t number = 0;  // for names: the frame's, or of several pictures of one frame that of the picture
    std::int64_t frame = 0;
    double degrees = 0.0;  // that the camera has turned
};

// Of these frames, one after the other or, where there is one and a turntable, around it. `turntable`: pictures of a whole turn; 0:
// none.
std::vector<Shot> shots_of(const std::vector<std::int64_t>& frames, std::int64_t turntable);

class FrameSequence {
public:
    // Opens the file and finds the frames that `options` ask for, which must outlive this. Throws InputError.
    FrameSequence(const std::string& path, const RenderOptions& options, Progress& progress);
    // Of a scene that is there, around which `options` ask for a turntable; they must outlive this.
    FrameSequence(LoadedScene scene, const RenderOptions& options);

    // From now on made in every frame. Before prepare().
    void set_changes(FrameChanges changes) { changes_ = std::move(changes); }
    // Where the file is cut off or wrong behind a frame, what is passed over, in words; "" where nothing is.
    const std::string& early_end() const { return early_end_; }
    // Whether it is wrong there, and not only cut off, or in a frame up to the last that is asked for, so that frames may be lost.
    bool is_damaged() const { return is_damaged_; }

    const std::vector<Shot>& shots() const { return shots_; }

    // Chooses the camera; before load(). Where it is fitted, all frames are read once; what is wrong with one of them, but for the
    // first, is left to load(), unless a film is to be made. Throws as load_scene().
    void prepare(Progress& progress);

    // The SHA-256 of what the other shots have to do with the picture of this one, after prepare(): the frame is seen by a camera,
    // in ranges and with a radius that may come of them.
    std::string sum_of(const Shot& shot) const;

    // The scene of a shot as the camera sees it then. Its light stays where it is in the scene while the camera turns.
    LoadedScene load(const Shot& shot);

    // For people: which of the frames that were loaded hold values beyond the first one's range, in which all are coloured; ""
    // where none does.
    std::string values_beyond_range() const;

    // Those of the lines that are not said of another frame already.
    std::vector<std::string> not_said(const std::vector<std::string>& lines);

private:
    // A frame as the file has it, with what all share: the radius of points, and the range, the scale and the order of categories
    // that values give, each that of the first frame in the list that has one, whichever is read first. So all parts of the list
    // have the same.
    const LoadedScene& read(std::int64_t frame);
    SphereData read_data(std::int64_t frame);
    void read_alone(std::int64_t frame);
    template <typename IsIt>
    void look_through(const IsIt& is_it);
    // What the camera comes of that is fitted to all these shots, besides the file; nothing where it cannot be told in short.
    std::optional<std::string> question_of_fit(const ViewAxes& axes) const;
    const LoadedScene* read_to_fit(std::int64_t frame);
    Camera fitted_camera(const LoadedScene& first, const ViewAxes& axes, Progress& progress);
    Camera camera_of(const Shot& shot) const { return turn_ ? turn_->camera(camera_, middle_, shot.degrees) : camera_; }

    const RenderOptions& options_;
    LookOptions look_;  // with what the first frame's values gave
    // Whether the frames were looked through for them, or need not be.
    bool knows_radius_ = false;
    bool knows_range_ = false;
    bool knows_scale_ = false;
    bool knows_order_ = false;
    std::optional<FrameReader> reader_{};  // none: of the one frame that is there
    FrameChanges changes_{};
    std::string early_end_{};
    bool is_damaged_ = false;
    std::vector<Shot> shots_{};
    LoadedScene present_{};  // the frame that was read last
    std::int64_t present_frame_ = -1;
    Camera camera_{};
    bool fitted_ = false;
    std::optional<Turn> turn_{};
    std::string shared_{};    // by all shots: the text that sum_of() begins with
    glm::dvec3 middle_{0.0};  // of what the camera is fitted to, or of the first frame
    std::set<std::string> said_{};
    std::set<std::int64_t> beyond_range_{};       // frames
    std::optional<double> radius_{};              // of all points, by the first frame that has one
    std::vector<std::string> radius_warnings_{};  // of that frame, until a picture has them
};

}  // namespace sphereview

// The mouse in the picture: selects, moves spheres, moves the camera.
#pragma once

#include <array>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "panels/panel_context.hpp"

namespace sphereview {

// The mouse in one redraw. Places are pixels of the picture from its top left corner.
struct PictureMouse {
    glm::dvec2 place{0.0};
    glm::dvec2 corner{0.0};  // the picture's, in pixels of the window; panels that open move it
    bool available = false;  // over the picture, and not used by a panel
    // By platform/window.hpp's MouseButton.
    std::array<bool, 3> pressed{};
    std::array<bool, 3> released{};
    bool double_clicked = false;
    double wheel = 0.0;  // > 0: away from the person
    bool control = false;
    bool shift = false;
    bool cancelled = false;       // Escape
    double drag_threshold = 4.0;  // pixels
};

// The picture that the mouse acts on.
struct PictureState {
    const Scene& scene;
    const Selection& selection;
    Camera camera;
    PictureSize size;
    glm::dvec3 pivot{0.0};                         // the centre of an orbit where nothing is seen
    std::function<std::int32_t(glm::dvec2)> pick;  // the visible sphere at a place, or visible_background
    // Selects the spheres that are seen in a rectangle, its upper left and lower right pixel included, or toggles them. Hidden
    // spheres could not be judged there; "Select all" and the filter reach these.
    std::function<void(Pixel, Pixel, bool toggles)> select_seen{};
    SceneBounds bounds{};    // zooming out ends where these look small
    bool trackball = false;  // orbit with no upright
    bool measures = false;   // clicks measure spheres instead of selecting, and drags move none
    // The centre of an orbit that begins beside all spheres; nothing: the middle of what is seen.
    std::optional<glm::dvec3> turns_about{};
    // Whether something drawn over the picture takes a click at this place.
    std::function<bool(glm::dvec2)> is_covered{};
};

// What the mouse did to the view. Its edits are in `actions`.
struct PictureConsequences {
    std::optional<Camera> camera;
    std::optional<glm::dvec3> pivot;
    std::optional<glm::dvec2> clicked{};  // the place of a click with the left button, without Ctrl
};

class MouseControl {
public:
    PictureConsequences redraw(const PictureMouse& mouse, const PictureState& state, std::uint64_t& gesture,
                               std::vector<Action>& actions);

    // Whether something follows the pointer.
    bool is_dragging() const { return mode_ != Mode::none && dragging_; }
    // Whether the view follows the pointer.
    bool moves_camera() const { return dragging_ && (mode_ == Mode::orbit || mode_ == Mode::pan || mode_ == Mode::zoom); }

    // The centre of the present orbit: the point under the pointer when the drag began, or, beside all spheres, the middle of what
    // is seen.
    std::optional<glm::dvec3> turns_about() const { return mode_ == Mode::orbit && dragging_ ? orbit_point_ : std::nullopt; }

    // The selection box that is being drawn, in pixels of the picture.
    struct Box {
        glm::dvec2 from{0.0};
        glm::dvec2 to{0.0};
    };
    std::optional<Box> box() const { return mode_ == Mode::box && dragging_ ? std::optional<Box>({start_, last_}) : std::nullopt; }

private:
    enum class Mode { none, orbit, pan, zoom, move_spheres, box };

    void press(int button, const PictureMouse& mouse, const PictureState& state);
    void follow_picture(const PictureMouse& mouse, const PictureState& state);
    void drag(const PictureMouse& mouse, const PictureState& state, PictureConsequences& consequences, std::uint64_t& gesture,
              std::vector<Action>& actions);
    void click(const PictureMouse& mouse, const PictureState& state, std::vector<Action>& actions) const;
    void select_box(const PictureMouse& mouse, const PictureState& state) const;
    void move_spheres(const PictureMouse& mouse, const PictureState& state, std::vector<Action>& actions);
    void remember_spheres(const glm::dvec2& place, const PictureState& state);
    void change_radius(const PictureMouse& mouse, const PictureState& state, std::int32_t picked, std::uint64_t& gesture,
                       std::vector<Action>& actions);

    Mode mode_ = Mode::none;
    int button_ = 0;
    bool dragging_ = false;   // the pointer has left the place of the press
    bool has_moved_ = false;  // spheres have moved; Escape takes that back
    glm::dvec2 start_{0.0};
    glm::dvec2 last_{0.0};
    // The picture's place in the drag's latest redraw.
    glm::dvec2 corner_{0.0};
    PictureSize size_{};
    glm::dvec3 grabbed_point_{0.0};  // the point of the scene under the press
    std::int32_t grabbed_ = -1;      // the sphere there
    std::optional<glm::dvec3> orbit_point_;
    // A drag moves spheres from their places when the pointer was at base_place_, so errors do not add up and the way back is
    // exact.
    glm::dvec2 base_place_{0.0};
    bool base_in_depth_ = false;
    std::vector<glm::dvec3> base_;  // the selected spheres' centres then
    std::uint64_t drag_gesture_ = 0;
    std::uint64_t wheel_gesture_ = 0;  // turning the wheel over one sphere is one step
    std::int32_t wheel_sphere_ = -1;
};

}  // namespace sphereview

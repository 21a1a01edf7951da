// What the mouse does in the picture: selects, moves spheres, moves the camera.
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
    glm::dvec2 corner{0.0};  // the picture's, in pixels of the window: a panel that opens moves it under a pointer that rests
    bool available = false;  // over the picture, and no panel wants the mouse
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

// What the mouse acts on.
struct PictureState {
    const Scene& scene;
    const Selection& selection;
    Camera camera;
    PictureSize size;
    glm::dvec3 pivot{0.0};                         // what an orbit turns about where nothing is seen
    std::function<std::int32_t(glm::dvec2)> pick;  // the visible sphere at a place, or visible_background
    // Selects the spheres that are seen in a rectangle, its upper left and lower right pixel included, or toggles them. A box
    // selects what is seen: what the picture does not show could not be judged there. "Select all" and the filter reach the rest.
    std::function<void(Pixel, Pixel, bool toggles)> select_seen{};
    SceneBounds bounds{};    // zooming out ends where these are small
    bool trackball = false;  // a drag turns the view as a ball, without an upright
    bool measures = false;   // a click measures a sphere instead of selecting it, and no drag moves one
    // What an orbit that begins beside all spheres turns about, instead of the middle of what is seen.
    std::optional<glm::dvec3> turns_about{};
    // Whether a click there is for something that is drawn over the picture: it selects nothing.
    std::function<bool(glm::dvec2)> is_covered{};
};

// What the mouse did to the view; edits are in `actions`.
struct PictureConsequences {
    std::optional<Camera> camera;
    std::optional<glm::dvec3> pivot;
    std::optional<glm::dvec2> clicked{};  // the place of a click with the left button, without Ctrl
};

class MouseControl {
public:
    PictureConsequences redraw(const PictureMouse& mouse, const PictureState& state, std::uint64_t& gesture,
                               std::vector<Action>& actions);

    // Something follows the pointer.
    bool is_dragging() const { return mode_ != Mode::none && dragging_; }
    // The view does.
    bool moves_camera() const { return dragging_ && (mode_ == Mode::orbit || mode_ == Mode::pan || mode_ == Mode::zoom); }

    // What the view is being turned about: the point under the pointer when the drag began, or, where that was no sphere's, the
    // middle of what is seen.
    std::optional<glm::dvec3> turns_about() const { return mode_ == Mode::orbit && dragging_ ? orbit_point_ : std::nullopt; }

    // The rectangle that is being drawn, from corner to corner, in pixels of the picture.
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
    bool dragging_ = false;   // the pointer has left the place where it went down
    bool has_moved_ = false;  // spheres, which Escape takes back
    glm::dvec2 start_{0.0};
    glm::dvec2 last_{0.0};
    // Where the picture was in the latest redraw of the drag.
    glm::dvec2 corner_{0.0};
    PictureSize size_{};
    glm::dvec3 grabbed_point_{0.0};  // in the scene, where the button went down
    std::int32_t grabbed_ = -1;      // the sphere there
    std::optional<glm::dvec3> orbit_point_;
    // A drag moves spheres from where they were when the pointer was at base_place_: nothing adds up, and back is back to the bit.
    glm::dvec2 base_place_{0.0};
    bool base_in_depth_ = false;
    std::vector<glm::dvec3> base_;  // the selected spheres' centres then
    std::uint64_t drag_gesture_ = 0;
    std::uint64_t wheel_gesture_ = 0;  // turns of the wheel over one sphere are one step
    std::int32_t wheel_sphere_ = -1;
};

}  // namespace sphereview

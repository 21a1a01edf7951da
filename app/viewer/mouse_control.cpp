#include "viewer/mouse_control.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "panels/widgets.hpp"
#include "scene/vectors.hpp"
#include "viewer/hidden_parts.hpp"

namespace sphereview {

namespace {

constexpr int left = 0;
constexpr int right = 1;
constexpr int middle = 2;

constexpr double zoom_per_pixel = 0.006;   // of a drag; the distance changes by this part
constexpr double zoom_per_click = 0.85;    // of the wheel; the distance is times this
constexpr double radius_per_click = 1.06;  // of the wheel
constexpr double smallest_scene = 0.25;    // of the picture's shorter side, where zooming out ends

constexpr int radius_digits = 5;  // that a turn of the wheel leaves
// Spheres whose numbers are rounded in decimal: of more, that would not keep up with the hand.
constexpr std::size_t most_rounded = 20'000;

// The point in the scene under the pointer: on the sphere there, else as deep as the pivot.
glm::dvec3 point_under(const PictureState& state, const glm::dvec2& place, std::int32_t picked) {
    if (picked >= 0) {
        const Sphere& sphere = state.scene.spheres[static_cast<std::size_t>(picked)];
        const auto depth = hit_depth(state.camera, state.size, place, sphere);
        return depth ? point_at(state.camera, state.size, place, *depth) : sphere.center;  // by rounding it may miss
    }
    const double depth = depth_of(state.camera, state.pivot);
    return point_at(state.camera, state.size, place, depth > 0.0 ? depth : 1.0);
}

// The middle of what some rays, spread over the picture, meet; the pivot where they meet nothing.
glm::dvec3 middle_of_seen(const PictureState& state) {
    constexpr int rays = 11;  // in a row, and rows
    std::optional<SceneBounds> seen;
    for (int i = 0; i < rays * rays; ++i) {
        const glm::dvec2 place{(i % rays + 0.5) * state.size.width / rays,
                               (static_cast<int>(i / rays) + 0.5) * state.size.height / rays};
        const std::int32_t picked = state.pick(place);
        if (picked < 0) continue;
        const glm::dvec3 hit = point_under(state, place, picked);
        if (!seen) seen = SceneBounds{.low = hit, .high = hit};
        seen->low = glm::min(seen->low, hit);
        seen->high = glm::max(seen->high, hit);
    }
    return seen ? seen->middle() : state.pivot;
}

// How much of the picture's shorter side the scene takes; infinite where its middle is not in front of the eye.
double part_of_picture(const Camera& camera, const SceneBounds& bounds) {
    const double depth = camera.orthographic() ? 1.0 : depth_of(camera, bounds.middle());
    if (!(depth > 0.0)) return std::numeric_limits<double>::infinity();
    return 0.5 * bounds.extent() / (depth * length_of(camera.right));
}

// The part where zooming out ends. A scene whose own camera shows it as small as that can be seen at half that size all the same.
double least_part(const PictureState& state) {
    return std::min(smallest_scene, 0.5 * part_of_picture(state.scene.camera, state.bounds));
}

// As zoomed(), but keeps the scene from getting lost in the distance.
Camera zoomed_within(const PictureState& state, const glm::dvec3& point, double factor) {
    const Camera next = zoomed(state.camera, point, factor);
    const double part = part_of_picture(next, state.bounds);
    return part < least_part(state) && part < part_of_picture(state.camera, state.bounds) ? state.camera : next;
}

// The exponent of the digit that one pixel's movement changes, where a pixel is so wide in the scene.
int exponent_of_pixel(double width) { return last_digit(width, 1); }

// A coordinate moved by so much, without the digits that adding doubles leaves behind: 0.1 + 0.2 is 0.3. What is not moved keeps
// its bits.
double moved_by(double from, double by) {
    if (by == 0.0) return from;
    constexpr int certain_digits = 15;
    return rounded_to(from + by, last_digit(std::max(std::fabs(from), std::fabs(by)), certain_digits));
}

std::string title_of(const PictureState& state) { return sphereview::title_of(state.scene, state.selection.numbers()); }

}  // namespace

PictureConsequences MouseControl::redraw(const PictureMouse& mouse, const PictureState& state, std::uint64_t& gesture,
                                         std::vector<Action>& actions) {
    PictureConsequences consequences;
    if (mode_ == Mode::none && mouse.available) {
        for (const int button : {left, right, middle}) {
            if (mouse.pressed[static_cast<std::size_t>(button)] && mode_ == Mode::none) press(button, mouse, state);
        }
        // With Control a second click takes the sphere out of the selection again.
        if (mouse.double_clicked && !mouse.control && !state.measures && grabbed_ >= 0) {
            const glm::dvec3 center = state.scene.spheres[static_cast<std::size_t>(grabbed_)].center;
            consequences.camera = centered_on(state.camera, center);
            consequences.pivot = center;
        }
        if (mouse.wheel != 0.0) {
            const std::int32_t picked = state.pick(mouse.place);
            if (mouse.control) {
                change_radius(mouse, state, picked, gesture, actions);
            } else {
                consequences.camera =
                    zoomed_within(state, point_under(state, mouse.place, picked), std::pow(zoom_per_click, mouse.wheel));
            }
        }
    }
    if (mode_ == Mode::none) return consequences;
    follow_picture(mouse, state);
    if (!dragging_ && glm::distance(mouse.place, start_) > mouse.drag_threshold) dragging_ = true;
    if (dragging_) drag(mouse, state, consequences, gesture, actions);
    if (mouse.cancelled) {
        if (has_moved_) actions.push_back(RunCommand{CommandId::undo});
        mode_ = Mode::none;
    } else if (mouse.released[static_cast<std::size_t>(button_)]) {
        if (!dragging_ && button_ == left) click(mouse, state, actions);
        if (!dragging_ && button_ == left && !mouse.control) consequences.clicked = start_;
        if (dragging_ && mode_ == Mode::box) select_box(mouse, state);
        mode_ = Mode::none;
    }
    if (mode_ == Mode::none) base_ = {};
    return consequences;
}

void MouseControl::press(int button, const PictureMouse& mouse, const PictureState& state) {
    button_ = button;
    dragging_ = false;
    has_moved_ = false;
    start_ = mouse.place;
    last_ = mouse.place;
    corner_ = mouse.corner;
    size_ = state.size;
    drag_gesture_ = 0;
    orbit_point_.reset();
    grabbed_ = state.pick(mouse.place);
    grabbed_point_ = point_under(state, mouse.place, grabbed_);
    if (button == right) {
        mode_ = Mode::zoom;
    } else if (button == middle) {
        mode_ = Mode::pan;
    } else if (mouse.control) {
        mode_ = Mode::box;
    } else if (grabbed_ >= 0 && !state.measures && state.selection.contains(static_cast<std::uint32_t>(grabbed_))) {
        mode_ = Mode::move_spheres;
    } else {
        mode_ = mouse.shift ? Mode::pan : Mode::orbit;
    }
}

// When the picture gets another place or size in the window, a drag stays where the pointer is on the screen, and spheres are moved
// on from where they are now: else the picture's own change would move them.
void MouseControl::follow_picture(const PictureMouse& mouse, const PictureState& state) {
    if (mouse.corner == corner_ && state.size == size_) return;
    start_ += corner_ - mouse.corner;
    last_ += corner_ - mouse.corner;
    corner_ = mouse.corner;
    size_ = state.size;
    if (mode_ == Mode::move_spheres && drag_gesture_ != 0) remember_spheres(last_, state);
}

void MouseControl::drag(const PictureMouse& mouse, const PictureState& state, PictureConsequences& consequences,
                        std::uint64_t& gesture, std::vector<Action>& actions) {
    const glm::dvec2 moved = mouse.place - last_;
    last_ = mouse.place;
    if (mode_ == Mode::move_spheres) {
        if (drag_gesture_ == 0) {
            drag_gesture_ = ++gesture;
            base_in_depth_ = mouse.shift;
            remember_spheres(start_, state);
        }
        if (mouse.shift != base_in_depth_) {
            base_in_depth_ = mouse.shift;
            remember_spheres(mouse.place, state);
        }
        move_spheres(mouse, state, actions);
        return;
    }
    if (moved == glm::dvec2(0.0)) return;
    if (mode_ == Mode::orbit) {
        // Half a turn across the shorter side.
        const double angle = std::numbers::pi / state.size.shorter_side();
        if (!orbit_point_)
            orbit_point_ = grabbed_ >= 0 ? grabbed_point_ : state.turns_about ? *state.turns_about : middle_of_seen(state);
        consequences.pivot = orbit_point_;
        const auto turn = state.trackball ? tumbled : orbited;
        consequences.camera = turn(state.camera, *orbit_point_, moved.x * angle, moved.y * angle);
    } else if (mode_ == Mode::pan) {
        const double depth = depth_of(state.camera, grabbed_point_);
        consequences.camera = panned(state.camera, state.size, moved, depth > 0.0 ? depth : 1.0);
    } else if (mode_ == Mode::zoom) {
        consequences.camera = zoomed_within(state, grabbed_point_, std::exp(zoom_per_pixel * moved.y));
    }
}

void MouseControl::click(const PictureMouse& mouse, const PictureState& state, std::vector<Action>& actions) const {
    if (state.measures && !mouse.control) {
        if (grabbed_ >= 0) actions.push_back(MeasureSphere{static_cast<std::uint32_t>(grabbed_)});
        return;
    }
    if (!mouse.control && state.is_covered && state.is_covered(start_)) return;
    Selection selection = state.selection;
    if (grabbed_ < 0) {
        if (mouse.control || mouse.shift) return;
        selection.clear();
    } else if (mouse.control) {
        selection.toggle(static_cast<std::uint32_t>(grabbed_));
    } else {
        selection.set_only(static_cast<std::uint32_t>(grabbed_));
    }
    const bool adds = grabbed_ >= 0 && selection.contains(static_cast<std::uint32_t>(grabbed_));
    if (selection != state.selection) actions.push_back(SelectSpheres{selection, adds});
}

void MouseControl::select_box(const PictureMouse& mouse, const PictureState& state) const {
    const auto pixel = [&](double x, double y) {
        return Pixel{std::clamp(static_cast<int>(std::floor(x)), 0, state.size.width - 1),
                     std::clamp(static_cast<int>(std::floor(y)), 0, state.size.height - 1)};
    };
    const glm::dvec2 low = glm::min(start_, mouse.place);
    const glm::dvec2 high = glm::max(start_, mouse.place);
    state.select_seen(pixel(low.x, low.y), pixel(high.x, high.y), mouse.shift);
}

void MouseControl::remember_spheres(const glm::dvec2& place, const PictureState& state) {
    base_.clear();
    base_.reserve(state.selection.size());
    for (const std::uint32_t number : state.selection.numbers()) base_.push_back(state.scene.spheres[number].center);
    base_place_ = place;
}

void MouseControl::move_spheres(const PictureMouse& mouse, const PictureState& state, std::vector<Action>& actions) {
    const auto& numbers = state.selection.numbers();
    const auto grabbed = std::ranges::lower_bound(numbers, static_cast<std::uint32_t>(grabbed_));
    // The file may have been reloaded meanwhile.
    if (grabbed == numbers.end() || *grabbed != static_cast<std::uint32_t>(grabbed_) || numbers.size() != base_.size()) return;
    const glm::dvec3 from = base_[static_cast<std::size_t>(grabbed - numbers.begin())];
    glm::dvec3 by{0.0};
    double pixel = 0.0;  // how wide it is there
    if (base_in_depth_) {
        // Along its ray.
        const Camera& camera = state.camera;
        const glm::dvec3 away = camera.orthographic() ? depth_of(camera, from) * (camera.center - camera.eye) : from - camera.eye;
        by = (std::exp(zoom_per_pixel * (base_place_.y - mouse.place.y)) - 1.0) * away;
        pixel = zoom_per_pixel * length_of(away);
    } else {
        const double depth = depth_of(state.camera, grabbed_point_);
        by = point_at(state.camera, state.size, mouse.place, depth) - point_at(state.camera, state.size, base_place_, depth);
        pixel = 2.0 * (state.camera.orthographic() ? 1.0 : depth) * length_of(state.camera.right) / state.size.shorter_side();
    }
    // A hand moves by pixels: more digits than that would only be noise in the file.
    for (int i = 0; i < 3; ++i) by[i] = rounded_to(by[i], exponent_of_pixel(pixel));
    ChangeSpheres change{numbers, {}};
    change.spheres.reserve(numbers.size());
    bool changes = false;
    const bool rounds = numbers.size() <= most_rounded;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const Sphere& before = state.scene.spheres[numbers[i]];
        Sphere& sphere = change.spheres.emplace_back(before);
        sphere.center = base_[i] + by;
        for (int axis = 0; axis < 3 && rounds; ++axis) sphere.center[axis] = moved_by(base_[i][axis], by[axis]);
        const glm::dvec3& center = sphere.center;
        if (!std::isfinite(center.x) || !std::isfinite(center.y) || !std::isfinite(center.z)) return;
        changes = changes || sphere != before;
    }
    if (!changes) return;
    has_moved_ = true;
    actions.push_back(EditScene{std::move(change), "Move " + title_of(state), drag_gesture_});
}

void MouseControl::change_radius(const PictureMouse& mouse, const PictureState& state, std::int32_t picked, std::uint64_t& gesture,
                                 std::vector<Action>& actions) {
    if (picked < 0 || !state.selection.contains(static_cast<std::uint32_t>(picked))) return;
    if (wheel_gesture_ != gesture || wheel_sphere_ != picked) {
        wheel_gesture_ = ++gesture;
        wheel_sphere_ = picked;
    }
    ChangeSpheres change{state.selection.numbers(), {}};
    for (const std::uint32_t number : change.numbers) {
        Sphere sphere = state.scene.spheres[number];
        sphere.radius *= std::pow(radius_per_click, mouse.wheel);
        if (change.numbers.size() <= most_rounded)
            sphere.radius = rounded_to(sphere.radius, last_digit(sphere.radius, radius_digits));
        if (!std::isfinite(sphere.radius) || !(sphere.radius > 0.0)) return;
        change.spheres.push_back(sphere);
    }
    actions.push_back(EditScene{std::move(change), "Change the radius of " + title_of(state), wheel_gesture_});
}

}  // namespace sphereview

#include "viewer/camera_flight.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>

#include "camera/fit.hpp"
#include "camera/navigation.hpp"

namespace sphereview {

namespace {

// A camera as directions and as what lies along them.
struct Pose {
    Pose(const Camera& camera, const glm::dvec3& pivot) {
        const ViewAxes axes = axes_of(camera);
        directions = glm::dmat3(axes.right, axes.up, axes.ahead);
        const glm::dmat3 along = glm::transpose(directions);
        size = std::hypot(camera.right.x, camera.right.y, camera.right.z);
        eye = along * (camera.eye - pivot);
        axis = along * (camera.center - camera.eye) / size;
    }

    glm::dmat3 directions;
    glm::dvec3 eye;   // from the pivot
    glm::dvec3 axis;  // to the screen's centre, in halves of its side
    double size;      // half of its side
};

}  // namespace

Camera CameraFlight::at(double part) const {
    const Pose from(from_, pivot_);
    const Pose to(to_, pivot_);
    // No turn makes a mirrored picture of one that is not.
    const bool mirrored = glm::determinant(to.directions) < 0.0;
    if ((glm::determinant(from.directions) < 0.0) != mirrored) return to_;
    glm::dmat3 flip(1.0);
    if (mirrored) flip[0][0] = -1.0;
    const glm::dquat turn = glm::slerp(glm::quat_cast(from.directions * flip), glm::quat_cast(to.directions * flip), part);
    const glm::dmat3 directions = glm::mat3_cast(turn) * flip;
    const glm::dvec3 eye = pivot_ + directions * glm::mix(from.eye, to.eye, part);
    // In perspective only the directions matter.
    const double size = to_.orthographic() ? glm::mix(from.size, to.size, part) : to.size;
    const glm::dvec3 axis = directions * (size * glm::mix(from.axis, to.axis, part));
    const Camera camera = camera_with(eye, axis, size * directions[0], size * directions[1], to_.projection);
    return camera_fault(camera) ? to_ : camera;
}

const Camera& CameraFlight::advance(Time now) {
    if (!begin_) begin_ = now;
    const double part = std::chrono::duration<double>(now - *begin_) / std::chrono::duration<double>(duration);
    // Slow at both ends.
    last_ = part < 1.0 ? at(part * part * (3.0 - 2.0 * part)) : to_;
    return last_;
}

}  // namespace sphereview

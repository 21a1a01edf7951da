// Moves the view to another one by itself. Any key, button or wheel ends a flight, and so does whatever else moves the view.
#pragma once

#include <chrono>
#include <glm/vec3.hpp>
#include <optional>

#include "scene/camera.hpp"

namespace sphereview {

// A flight from one camera to another in `duration`, turning about the pivot. The caller gives the times.
class CameraFlight {
public:
    using Time = std::chrono::steady_clock::time_point;
    static constexpr std::chrono::milliseconds duration{300};

    CameraFlight(const Camera& from, const Camera& to, const glm::dvec3& pivot)
        : from_(from), to_(to), last_(from), pivot_(pivot) {}

    // The camera at that time; the flight begins with the first call. From `duration` on exactly the target.
    const Camera& advance(Time now);
    bool has_arrived() const { return last_ == to_; }
    // The last result of advance(). If the view differs from it, something else has moved the view.
    const Camera& last() const { return last_; }

private:
    Camera at(double part) const;

    Camera from_;
    Camera to_;
    Camera last_;
    glm::dvec3 pivot_;
    std::optional<Time> begin_;
};

}  // namespace sphereview

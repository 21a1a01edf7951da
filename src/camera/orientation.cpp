#include "camera/orientation.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/number.hpp"
#include "camera/fit.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

std::array<AxisEnd, 6> axis_ends(const Camera& camera) {
    const CameraAxes view = camera_axes(camera);
    std::array<AxisEnd, 6> ends;
    for (int i = 0; i < 6; ++i) {
        glm::dvec3 direction(0.0);
        direction[i / 2] = i % 2 == 0 ? 1.0 : -1.0;
        ends[static_cast<std::size_t>(i)] = {
            i / 2, i % 2 == 0, {dot(direction, view.right), -dot(direction, view.up)}, -dot(direction, view.ahead)};
    }
    std::ranges::stable_sort(ends, {}, &AxisEnd::toward);
    return ends;
}

CameraAxes axes_seen_from(const Camera& camera, const AxisEnd& end) {
    const bool mirrored = camera_axes(camera).mirrored;
    // The front of a mirrored camera is on the side of +z.
    const bool from_front = end.positive == mirrored;
    const double azimuth = end.axis == 0 ? (end.positive ? 90.0 : -90.0) : end.axis == 2 && !from_front ? 180.0 : 0.0;
    const double elevation = end.axis == 1 ? (end.positive ? 90.0 : -90.0) : 0.0;
    const ViewAxes axes = with_hand_of(axes_of(camera), axes_from(azimuth, elevation));
    return {axes.right, axes.up, axes.ahead, mirrored};
}

std::optional<ScaleBar> scale_bar(const Camera& camera, PictureSize size, const glm::dvec3& point, double most_pixels) {
    const CameraAxes view = camera_axes(camera);
    const double half = length_of(camera.right);
    ScaleBar bar;
    double enlarged = 1.0;  // how many times as large as on the screen things are at the point
    if (!camera.orthographic()) {
        bar.depth = dot(point - camera.eye, view.ahead);
        enlarged = *bar.depth / dot(camera.center - camera.eye, view.ahead);
    }
    const double unit = 2.0 * half * enlarged / size.shorter_side();  // of a pixel
    const double most = most_pixels * unit;
    if (!(unit > 0.0) || !std::isfinite(most) || !std::isfinite(enlarged)) return std::nullopt;
    bar.length = round_number_below(most);
    bar.pixels = bar.length / unit;
    if (!(bar.length > 0.0)) return std::nullopt;
    return bar;
}

std::string in_words(const ScaleBar& bar) {
    const std::string length = shortest(bar.length);
    if (!bar.depth) return length;
    double depth = *bar.depth;
    parse_double(decimal(depth, std::chars_format::scientific, 2), depth);
    return length + " at depth " + shortest(depth);
}

}  // namespace sphereview

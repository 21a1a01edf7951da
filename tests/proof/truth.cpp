#include "proof/truth.hpp"

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>

namespace sphereview {

namespace {

namespace multiprecision = boost::multiprecision;
using Wide = multiprecision::number<multiprecision::cpp_bin_float<256, multiprecision::digit_base_2>, multiprecision::et_off>;
using WideVector = std::array<Wide, 3>;

WideVector wide(const glm::dvec3& v) { return {Wide(v.x), Wide(v.y), Wide(v.z)}; }
WideVector times(const WideVector& v, const Wide& factor) { return {v[0] * factor, v[1] * factor, v[2] * factor}; }
WideVector sum(const WideVector& a, const WideVector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Wide dot(const WideVector& a, const WideVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Wide length(const WideVector& v) { return sqrt(dot(v, v)); }

}  // namespace

Truth true_hit(const Trial& trial) {
    const WideVector minus_eye = times(wide(trial.camera.eye), -1);
    const RayCoefficients k = ray_coefficients(trial.size, trial.pixel);
    const WideVector forward = times(sum(wide(trial.camera.center), minus_eye), trial.size.shorter_side());
    const WideVector right = times(wide(trial.camera.right), k.across);
    const WideVector up = times(wide(trial.camera.up), k.upward);
    const bool parallel = trial.camera.orthographic();
    const WideVector ray = parallel ? forward : sum(forward, sum(right, up));
    const Wide ray_length = length(ray);

    const WideVector from_eye = sum(wide(trial.sphere.center), minus_eye);
    const WideVector to_origin = times(sum(right, up), 1 / Wide(trial.size.shorter_side()));
    const WideVector center = parallel ? sum(from_eye, times(to_origin, -1)) : from_eye;
    const Wide radius = trial.sphere.radius;
    const Wide b = dot(center, ray) / ray_length;
    const Wide c = dot(center, center) - radius * radius;
    const Wide d = b * b - c;

    Truth truth;
    const auto hits_at = [&](const Wide& distance) {
        truth.hit = true;
        truth.distance = static_cast<double>(distance);
        const WideVector along = times(ray, distance / ray_length);
        const WideVector point = parallel ? sum(to_origin, along) : along;
        truth.point = {static_cast<double>(point[0]), static_cast<double>(point[1]), static_cast<double>(point[2])};
    };
    truth.condition = static_cast<double>((length(forward) + length(right) + length(up)) / ray_length);
    truth.side = c > 0 ? EyeSide::outside : c < 0 ? EyeSide::inside : EyeSide::on_surface;
    switch (truth.side) {
        case EyeSide::outside:
            if (b > 0 && d >= 0) hits_at(b - sqrt(d));
            break;
        case EyeSide::inside: hits_at(b + sqrt(d)); break;
        case EyeSide::on_surface:
            if (b > 0) hits_at(2 * b);
            break;
        case EyeSide::in_plane: break;
    }
    return truth;
}

bool claims_hold(const Truth& truth, double low, double high) {
    const bool missed = low == std::numeric_limits<double>::infinity();
    const bool sure = high < std::numeric_limits<double>::infinity();
    if (!truth.hit) return !sure;
    return !missed && low <= truth.distance && (!sure || truth.distance <= high);
}

}  // namespace sphereview

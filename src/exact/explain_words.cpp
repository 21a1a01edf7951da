#include "exact/explain_words.hpp"

#include <cmath>

#include "base/text.hpp"

namespace sphereview {

namespace {

constexpr const char* unshown_small = "too small for a double to show; decided exactly";
constexpr const char* unshown_large = "too large for a double to show; decided exactly";

}  // namespace

std::string number_in_words(double value, int sign) {
    const std::string side = sign > 0 ? "(above 0, " : "(below 0, ";
    if (std::isinf(value)) return (value > 0.0 ? "(above 0, " : "(below 0, ") + std::string(unshown_large) + ")";
    if (value == 0.0 && sign != 0) return side + unshown_small + ")";
    return shortest(value + 0.0);  // -0 becomes 0
}

std::string vector_in_words(const glm::dvec3& v) {
    const auto part = [](double value) {
        return std::isinf(value) ? (value > 0.0 ? "" : "-") + std::string("(too large for a double)") : shortest(value + 0.0);
    };
    return "(" + part(v.x) + ", " + part(v.y) + ", " + part(v.z) + ")";
}

const char* why(const ExplainedHit& hit) {
    const bool tangent = hit.discriminant_sign == 0;
    switch (hit.counts) {
        case CountingRoot::t1:
            return tangent ? "one root, positive: the ray is tangent, and t1 = t2 counts"
                           : "both roots are positive (c > 0: the eye is outside, and b < 0): the smaller, t1, counts";
        case CountingRoot::t2_inside: return "c < 0: the eye is inside the sphere, so t1 < 0 < t2, and t2 counts";
        case CountingRoot::t2_surface: return "c = 0: the eye is on the surface; t1 = 0 is not positive, and t2 counts";
    }
    return "";
}

const char* level_in_words(DecisionLevel level) {
    switch (level) {
        case DecisionLevel::in_float: return "float arithmetic, with its proven error bound, is enough to decide this pixel";
        case DecisionLevel::in_double: return "too close for float arithmetic; double, with its proven error bound, decides";
        case DecisionLevel::exactly: return "too close for float and double; only exact arithmetic decides";
    }
    return "";
}

HitInWords in_words(const ExplainedHit& hit) {
    const int c_sign = hit.eye == EyeSide::outside ? 1 : hit.eye == EyeSide::inside ? -1 : 0;
    const int b_sign = c_sign >= 0 ? -1 : 0;  // a hit in front of the eye, or nothing known
    const bool too_near = hit.discriminant_sign > 0 && hit.t1 == hit.t2 && hit.t2 != 0.0 && std::isfinite(hit.t2);
    return {
        .a = number_in_words(hit.a, 1),
        .b = number_in_words(hit.b, b_sign),
        .c = number_in_words(hit.c, c_sign),
        .discriminant = number_in_words(hit.discriminant, hit.discriminant_sign),
        .roots = hit.discriminant_sign > 0 ? "> 0: two roots" : "= 0 exactly: tangent, one root",
        .t1 = number_in_words(hit.t1, c_sign),
        .t2 = number_in_words(hit.t2, 1) + (too_near ? "  (larger than t1 by too little for a double to show)" : ""),
        .t = number_in_words(hit.t, 1),
        .point = vector_in_words(hit.point),
        .normal = vector_in_words(hit.normal),
    };
}

}  // namespace sphereview

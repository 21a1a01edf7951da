// Where the roots of quadratics lie, from the signs of polynomials alone: no square root and no squaring of one.
#pragma once

namespace sphereview::oracle {

// A t^2 - 2 b t + c with A > 0, which belongs to the ray; only with real roots.
template <typename Integer>
struct Quadratic {
    Integer b;
    Integer c;
};

enum class Which { smaller, larger };

// The sign of root - numerator / denominator (> 0), for one of the roots of A t^2 - 2 b t + c.
template <typename Integer>
int root_against(const Integer& a, const Quadratic<Integer>& p, Which which, const Integer& numerator, const Integer& denominator) {
    // The polynomial there, times the denominator's square: negative only between the roots.
    const Integer value = numerator * (a * numerator - 2 * p.b * denominator) + p.c * denominator * denominator;
    const int sign = value.sign();
    const bool smaller = which == Which::smaller;
    if (sign < 0) return smaller ? -1 : 1;
    const int side = Integer(a * numerator - p.b * denominator).sign();  // of the place, seen from the vertex b / A
    if (sign > 0) return -side;
    // The place is one of the roots; both, at the vertex.
    if (side < 0) return smaller ? 0 : 1;
    if (side > 0) return smaller ? -1 : 0;
    return 0;
}

// The sign of (a root of p) - (a root of q), by the sign of q at the root of p. There q = q - p, a straight line.
template <typename Integer>
int compare_roots(const Integer& a, const Quadratic<Integer>& p, Which of_p, const Quadratic<Integer>& q, Which of_q) {
    // q(t) - p(t) = slope t + offset
    const Integer slope = 2 * (p.b - q.b);
    const Integer offset = q.c - p.c;
    int sign = 0;
    if (slope == 0) {
        sign = offset.sign();
    } else if (slope > 0) {
        sign = root_against(a, p, of_p, Integer(-offset), slope);
    } else {
        sign = -root_against(a, p, of_p, offset, Integer(-slope));
    }
    const bool smaller = of_q == Which::smaller;
    if (sign < 0) return smaller ? 1 : -1;              // between the roots of q
    const int side = root_against(a, p, of_p, q.b, a);  // of the root of p, seen from q's vertex
    if (sign > 0) return side;
    if (side < 0) return smaller ? 0 : -1;
    if (side > 0) return smaller ? 1 : 0;
    return 0;
}

}  // namespace sphereview::oracle

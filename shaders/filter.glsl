// One sphere against one ray, with proven bounds. Derivation: docs/exactness.md. Twin: src/exact/filter.hpp.
// No infinities here: drivers disagree about them. No distance reaches `never`.
const float never = 3.0e38;

// Some drivers compute sqrt(x) as x inversesqrt(x), which at 0 is no number. Off by at most 2^-61, far below every bound.
float root(float x) { return sqrt(max(x, 1.9e-37)); }

// The interval of the hit's distance along the ray. Missed: x is never. Not sure to be a hit: y is never.
// Haines, Guenther and Akenine-Moeller, "Precision improvements for ray/sphere intersection", 2019: the closest approach h
// first, because b^2 - c cancels.
vec2 hit_bounds(vec4 sphere, float w, vec3 ray) {
    float along = dot(sphere.xyz, ray);
    if (sphere.w == 0.0) {  // the roots are 0, which does not count, and 2 b
        return vec2(along < -w ? never : 2.0 * (along - w), along > w ? 2.0 * (along + w) : never);
    }
    float r = abs(sphere.w);
    vec3 approach = sphere.xyz - along * ray;
    float h = root(dot(approach, approach));
    bool inside = sphere.w < 0.0;
    if (!inside && (h - r > w || along < -w)) return vec2(never);
    float longest = root(max(r - h + w, 0.0) * (r + h + w));
    float shortest = root(max(r - h - w, 0.0) * max(r + h - w, 0.0));
    if (inside) return vec2(along + shortest - w, along + longest + w);
    bool sure = r - h > w && along > w;
    return vec2(along - longest - w, sure ? along - shortest + w : never);
}

// One sphere against one ray, with proven bounds. Derivation: docs/exactness.md. Twin: src/exact/filter.hpp.
// No infinities here: drivers disagree about them. No distance reaches `never`.
const float never = 3.0e38;

// Some drivers compute sqrt(x) as x inversesqrt(x), which at 0 is no number. Off by at most 2^-61, far below every bound.
float root(float x) { return sqrt(max(x, 1.9e-37)); }

// The interval of the hit's distance along the ray, with the sphere relative to the ray's origin. Missed: x is never. Not sure to be a hit: y is never.
// Haines, Guenther and Akenine-Moeller, "Precision improvements for ray/sphere intersection", 2019: the closest approach h
// first, because b^2 - c cancels.
// Without branches: llvmpipe only masks them, and pays for both sides.
vec2 hit_bounds(vec4 sphere, float w, vec3 ray) {
    float along = dot(sphere.xyz, ray);
    float r = abs(sphere.w);
    vec3 approach = sphere.xyz - along * ray;
    float h = root(dot(approach, approach));
    float longest = root(max(r - h + w, 0.0) * (r + h + w));
    float shortest = root(max(r - h - w, 0.0) * max(r + h - w, 0.0));
    bool missed = h - r > w || along < -w;
    bool sure = r - h > w && along > w;
    vec2 outside = vec2(missed ? never : along - longest - w, sure ? along - shortest + w : never);
    vec2 inside = vec2(along + shortest - w, along + longest + w);
#ifdef ORTHOGRAPHIC
    // The plane that rays begin in meets the sphere: the smaller root where that is positive, else the larger.
    vec2 near = vec2(along - longest - w, along - shortest + w);
    bool no_hit = h - r > w || inside.y < 0.0;
    float low = near.y <= 0.0 ? inside.x : near.x;
    float high = near.x > 0.0 ? near.y : inside.x > 0.0 ? inside.y : never;
    vec2 in_plane = vec2(no_hit ? never : low, r - h > w ? high : never);
    vec2 anywhere = vec2(0.0, never);
    return sphere.w > 0.0 ? outside : sphere.w < 0.0 ? in_plane : anywhere;
#else
    // The roots are 0, which does not count, and 2 b.
    vec2 on_surface = vec2(along < -w ? never : 2.0 * (along - w), along > w ? 2.0 * (along + w) : never);
    return sphere.w > 0.0 ? outside : sphere.w < 0.0 ? inside : on_surface;
#endif
}

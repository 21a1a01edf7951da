// The rays of a picture; ORTHOGRAPHIC is defined where all have one direction. Twin: src/exact/rays.hpp.
#include "draw.glsl"

#ifdef ORTHOGRAPHIC
vec3 ray_direction(ivec2 pixel, ivec2 size) { return forward.xyz * inversesqrt(dot(forward.xyz, forward.xyz)); }

// Where the ray begins, relative to the eye.
vec3 ray_origin(ivec2 pixel, ivec2 size) {
    float across = float(2 * pixel.x + 1 - size.x);
    float upward = float(size.y - 1 - 2 * pixel.y);
    return upward * up.xyz + across * right.xyz;
}

// At least |x| + |y| + |z| of what origins are made of.
float reach_of_origins() { return forward.w; }
#else
// The direction of the ray through the centre of a pixel, (0, 0) at the top left, of a picture of that size; of length 1.
vec3 ray_direction(ivec2 pixel, ivec2 size) {
    float across = float(2 * pixel.x + 1 - size.x);
    float upward = float(size.y - 1 - 2 * pixel.y);
    vec3 direction = (forward.xyz + upward * up.xyz) + across * right.xyz;
    return direction * inversesqrt(dot(direction, direction));
}

vec3 ray_origin(ivec2 pixel, ivec2 size) { return vec3(0.0); }

float reach_of_origins() { return 0.0; }
#endif

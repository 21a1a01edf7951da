// The rays of a picture. Twin: src/exact/rays.hpp.
#include "draw.glsl"

// The direction of the ray through the centre of a pixel, (0, 0) at the top left, of a picture of that size; of length 1.
vec3 ray_direction(ivec2 pixel, ivec2 size) {
    float across = float(2 * pixel.x + 1 - size.x);
    float upward = float(size.y - 1 - 2 * pixel.y);
    vec3 direction = (forward.xyz + upward * up.xyz) + across * right.xyz;
    return direction * inversesqrt(dot(direction, direction));
}

#version 330 core
// Solves the ray's quadratic for every sphere and writes the number of the visible one.
#include "frame.glsl"
#include "spheres.glsl"
#include "visible.glsl"

out int visible;

// The direction of the ray through the centre of a pixel, (0, 0) at the top left; of length 1.
vec3 ray_direction(ivec2 pixel) {
    float across = float(2 * pixel.x + 1 - picture_size.x);
    float upward = float(picture_size.y - 1 - 2 * pixel.y);
    vec3 direction = (forward.xyz + upward * up.xyz) + across * right.xyz;
    return direction * inversesqrt(dot(direction, direction));
}

void main() {
    // Row 0 of the attachment is the top row of the block.
    vec3 ray = ray_direction(block_origin + ivec2(gl_FragCoord.xy));
    float nearest = 3.0e38;
    int best = visible_background;
    for (int i = 0; i < sphere_count; ++i) {
        vec4 sphere = sphere_at(i);
        // Haines, Guenther and Akenine-Moeller, "Precision improvements for ray/sphere intersection", 2019: the closest
        // approach first, because b^2 - c cancels.
        float along = dot(sphere.xyz, ray);
        float h = length(sphere.xyz - along * ray);
        if (h > sphere.w) continue;
        float half_chord = sqrt((sphere.w - h) * (sphere.w + h));
        float entry = along - half_chord;
        float t = entry > 0.0 ? entry : along + half_chord;
        if (t > 0.0 && t < nearest) {
            nearest = t;
            best = i;
        }
    }
    visible = best;
}

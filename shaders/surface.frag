#version 330 core
// Turns the visible-sphere buffer into colours that show the spheres' shape, for a window. Formulae: docs/shading.md.
// Twin: src/shade/picture_shader.cpp. shading_NAME: a mode's number, by its row in src/shade/shading.hpp.
#include "background.glsl"
#include "colors.glsl"
#include "seen.glsl"

out vec4 color;

float between_0_and_1(float value) { return clamp(value, 0.0, 1.0); }

void main() {
    ivec2 pixel = window_pixel();
    int index = seen_at(pixel);
    if (index <= visible_background) {
        color = background_at(pixel);
        return;
    }
    ivec2 at = clamp(pixel, ivec2(0), picture_size - 1);
    vec3 ray = ray_direction(at, picture_size);
    vec4 sphere = sphere_at(index);
    vec3 center = sphere.xyz - ray_origin(at, picture_size);
    float radius = sphere.w != 0.0 ? abs(sphere.w) : length(center);  // 0: the eye is on the surface
    bool outside = sphere.w > 0.0;
#ifdef ORTHOGRAPHIC
    outside = outside || length(center) > radius;
#endif
    float side = outside ? 1.0 : -1.0;
    float along = dot(center, ray);
    vec3 approach = center - along * ray;
    approach -= dot(approach, ray) * ray;  // what rounding left along the ray
    // A sphere that float cannot hold is shown as if it were hit in its middle.
    vec3 q = approach / max(radius, 1e-36);
    float h = length(q);
    float facing = sqrt(max((1.0 - h) * (1.0 + h), 0.0));
    float depth = between_0_and_1((along - side * (facing * radius) - nearest_depth) * inverse_depth_range);
    vec3 shaded = vec3(1.0, 0.0, 1.0);  // of a mode without a branch here
    if (shading == shading_normal) {
        vec3 normal = -(side * q) - facing * ray;
        vec3 seen = vec3(dot(normal, axis_right.xyz), dot(normal, axis_up.xyz), dot(normal, axis_toward.xyz));
        shaded = clamp(0.5 + 0.5 * seen, 0.0, 1.0);
    } else if (shading == shading_headlight) {
        shaded = color_at(index).rgb * (0.3 + 0.7 * facing / (1.0 + depth));
    } else if (shading == shading_studio) {
        // What moves has no shadows: the sky and the key light of a free surface, and the sun. docs/shading.md. Twin:
        // brightness_of_free_sky() and shown_part() in src/shade/brightness.hpp.
        vec3 normal = -(side * q) - facing * ray;
        float toward_key = 0.5 + 0.5 * dot(normal, key_light.xyz);
        float sky = 0.62 + 0.45 * sun_light.w * toward_key * toward_key * (0.5 + 0.5 * toward_key);
        float brightness = key_light.w * sky + max(dot(normal, sun_light.xyz), 0.0);
        shaded = color_at(index).rgb * min(1.8 * brightness / (0.8 + brightness), 1.0);
    } else if (shading == shading_depth) {
        shaded = vec3(1.0 - 0.8 * depth);
    }
    color = vec4(shaded, 1.0);
}

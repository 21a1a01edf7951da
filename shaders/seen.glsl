// The sphere that a pixel of a picture in a window shows. Where only every few pixels were traced (COARSE is defined), a pixel's own
// ray tries the spheres that the traced pixels around it show: their edges are as smooth as those of a fine picture.
#include "rays.glsl"
#include "spheres.glsl"
#include "filter.glsl"
#include "visible.glsl"
#include "window.glsl"

uniform isampler2D visible_spheres;

// A window has no holes.
int seen_in(ivec2 texel) { return best_guess(texelFetch(visible_spheres, texel, 0).r); }

#ifdef COARSE
// An index, or visible_background.
int seen_at(ivec2 pixel) {
    ivec2 at = clamp(pixel, ivec2(0), picture_size - 1);
    int own = seen_in(at >> grid_shift);
    // The texels whose traced pixels are around this one.
    ivec2 last = (picture_size - 1) >> grid_shift;
    ivec2 first = max((at - ((1 << grid_shift) >> 1)) >> grid_shift, ivec2(0));
    ivec2 second = min(first + 1, last);
    ivec4 around = ivec4(seen_in(first), seen_in(ivec2(second.x, first.y)), seen_in(ivec2(first.x, second.y)), seen_in(second));
    bool differ = any(notEqual(around, ivec4(own)));
    if (!differ) return own;
    bool beside_background = any(equal(around, ivec4(visible_background)));
    vec3 ray = ray_direction(at, picture_size);
    vec3 origin = ray_origin(at, picture_size);
    float distance = never;
    // Where no sphere is hit that is known here, others may be, which no traced pixel shows: between spheres the nearest one's stays.
    int seen = beside_background ? visible_background : own;
    for (int tried = 0; tried < 4; ++tried) {
        vec4 sphere = sphere_at(max(around.x, 0));
        float hit = hit_bounds(vec4(sphere.xyz - origin, sphere.w), 0.0, ray).x;
        bool nearer = around.x > visible_background && hit < distance;
        distance = nearer ? hit : distance;
        seen = nearer ? around.x : seen;
        around = around.yzwx;
    }
    return seen;
}
#else
int seen_at(ivec2 pixel) { return seen_in(clamp(pixel, ivec2(0), picture_size - 1)); }
#endif

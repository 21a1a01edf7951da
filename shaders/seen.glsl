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
// Where a ray of length 1 first meets a sphere that is given relative to the ray's origin; as exact as the eye asks.
float hit_distance(vec3 center, float radius, vec3 ray) {
    float along = dot(center, ray);
    vec3 approach = center - along * ray;
    float square = radius * radius - dot(approach, approach);
    float half_chord = root(square);
    float hit = along > half_chord ? along - half_chord : along + half_chord;
    return square >= 0.0 && hit > 0.0 ? hit : never;
}

// An index, or visible_background.
int seen_at(ivec2 pixel) {
    ivec2 at = clamp(pixel, ivec2(0), picture_size - 1);
    // The texels whose traced pixels are around this one; its own is one of them.
    ivec2 last = (picture_size - 1) >> grid_shift;
    ivec2 first = max((at - ((1 << grid_shift) >> 1)) >> grid_shift, ivec2(0));
    ivec2 second = min(first + 1, last);
    ivec4 around = ivec4(seen_in(first), seen_in(ivec2(second.x, first.y)), seen_in(ivec2(first.x, second.y)), seen_in(second));
    bvec2 in_first = equal(at >> grid_shift, first);
    ivec2 of_row = in_first.y ? around.xy : around.zw;
    int own = in_first.x ? of_row.x : of_row.y;
    bool more = any(notEqual(around, ivec4(own)));
    // Where no sphere is hit that is known here, others may be, which no traced pixel shows: between spheres the own one stays.
    int seen = more && any(equal(around, ivec4(visible_background))) ? visible_background : own;
    if (more) {
        vec3 ray = ray_direction(at, picture_size);
        vec3 origin = ray_origin(at, picture_size);
        float distance = never;
        int tried = 0;
        do {
            vec4 sphere = sphere_at(max(around.x, 0));
            vec3 center = sphere.xyz - origin;
            float hit = hit_distance(center, sphere.w != 0.0 ? abs(sphere.w) : length(center), ray);  // 0: the eye is on the surface
            bool nearer = around.x > visible_background && hit < distance;
            distance = nearer ? hit : distance;
            seen = nearer ? around.x : seen;
            around = around.yzwx;
            ++tried;
        } while (tried < 4);
    }
    return seen;
}
#else
int seen_at(ivec2 pixel) { return seen_in(clamp(pixel, ivec2(0), picture_size - 1)); }
#endif

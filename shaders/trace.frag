#version 330 core
// Solves the ray's quadratic for every sphere that the pixel can show and writes the number of the visible one, or that it is doubtful.
#include "candidates.glsl"
#include "rays.glsl"
#include "spheres.glsl"
#include "visible.glsl"
#include "filter.glsl"

out int visible;

void main() {
    // Row 0 of the attachment is the top row of the block. In a coarse grid a texel stands for the pixels around this one.
    ivec2 pixel = min(block_origin + (ivec2(gl_FragCoord.xy) << grid_shift), picture_size - 1);
    vec3 ray = ray_direction(pixel, picture_size);
    vec3 origin = ray_origin(pixel, picture_size);
    float smallest_high = never;  // over the sure hits
    int sure = -1;
    float low = never;            // the smallest lower bound over all candidates
    int guess = -1;
    float second_low = never;     // the smallest over all candidates but the guess
    // The loops end, rather than begin, with their tests: where nothing is left to do for any of its pixels, llvmpipe runs a
    // loop's body once all the same.
    int level = 0;
    do {
        ivec2 list = list_at(levels[level], pixel);
        int place = list.x;
        uvec2 candidate = candidate_at(place);
        bool more = place < list.y && nearest(candidate) <= smallest_high;
        if (more) do {
            int index = int(candidate.x);
            vec4 sphere = sphere_at(index);
            float w = error_scale * (abs(sphere.x) + abs(sphere.y) + abs(sphere.z) + abs(sphere.w) + reach_of_origins());
            vec2 hit = hit_bounds(vec4(sphere.xyz - origin, sphere.w), w, ray);
            bool nearer = hit.x < low;
            second_low = min(second_low, nearer ? low : hit.x);
            low = nearer ? hit.x : low;
            guess = nearer ? index : guess;
            bool surer = hit.y < smallest_high;
            smallest_high = surer ? hit.y : smallest_high;
            sure = surer ? index : sure;
            ++place;
            candidate = candidate_at(place);
            // What begins beyond a sure hit is not seen, and neither is what comes after it.
            more = place < list.y && nearest(candidate) <= smallest_high;
        } while (more);
        ++level;
    } while (level < level_count);
    bool decided = all_doubtful == 0 && guess == sure && (guess < 0 || second_low > smallest_high);
    visible = decided ? guess : doubtful(guess);
}

// The spheres, in the order of their numbers. Twin: src/gpu/layouts.hpp. SPHERE_CAPACITY is set by the program.
layout(std140) uniform Spheres {
    // xyz: centre relative to the eye; w: radius, negative when the eye is inside, 0 when it is exactly on the surface.
    vec4 center_radius[SPHERE_CAPACITY];
};

vec4 sphere_at(int number) { return center_radius[number]; }

// The spheres, in the order of their numbers. Twin: src/gpu/layouts.hpp. SPHERE_CAPACITY is set by the program.
layout(std140) uniform Spheres {
    vec4 center_radius[SPHERE_CAPACITY];  // centre relative to the eye, radius
};

vec4 sphere_at(int number) { return center_radius[number]; }

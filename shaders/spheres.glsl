// The spheres, in the order of their indices. Twin: src/gpu/layouts.hpp. In a uniform block of SPHERE_CAPACITY elements where
// that is defined, else in a table.
// xyz: centre relative to the eye; w: radius, negative when the eye is inside, 0 when it is exactly on the surface. Orthographic:
// negative when the sphere meets the plane that rays begin in.
#include "tables.glsl"

#ifdef SPHERE_CAPACITY
layout(std140) uniform Spheres {
    vec4 center_radius[SPHERE_CAPACITY];
};

vec4 sphere_at(int index) { return center_radius[index]; }
#else
uniform float_table sphere_table;

vec4 sphere_at(int index) { return table_fetch(sphere_table, index); }
#endif

// The spheres' colours, 0..1, where the spheres are (spheres.glsl).
#include "tables.glsl"

#ifdef SPHERE_CAPACITY
layout(std140) uniform Colors {
    vec4 colors[SPHERE_CAPACITY];
};

vec4 color_at(int index) { return colors[index]; }
#else
uniform float_table color_table;

vec4 color_at(int index) { return table_fetch(color_table, index); }
#endif

// The lists of the spheres that each tile of the picture can show. Twins: src/exact/candidates.hpp, src/gpu/layouts.hpp.
#include "tables.glsl"

uniform uint_table candidate_table;   // x: a sphere's index; y: the bits of nearest()
uniform uint_table list_begin_table;  // where each tile's list begins; one more, for the end of the last

// The range of candidates, end excluded, that a pixel of the picture walks in a level.
ivec2 list_at(ivec4 level, ivec2 pixel) {
    ivec2 at = pixel >> level.x;
    int tile = level.z + at.y * level.y + at.x;
    return ivec2(table_fetch(list_begin_table, tile).x, table_fetch(list_begin_table, tile + 1).x);
}

// Also for the place after the last.
uvec2 candidate_at(int place) { return table_fetch(candidate_table, place).xy; }

// No hit of the candidate is nearer to the eye than this.
float nearest(uvec2 candidate) { return uintBitsToFloat(candidate.y); }

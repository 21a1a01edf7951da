// The lists of the spheres that each tile of the picture can show. Twins: src/exact/candidates.hpp, src/gpu/layouts.hpp.
#include "tables.glsl"

uniform uint_table candidate_table;   // x: a sphere's index; y: the bits of the distance below which none of it is hit
uniform uint_table list_begin_table;  // where each tile's list begins; one more, for the end of the last

// The range of candidates, end excluded, that a pixel of the picture walks in a level.
ivec2 list_at(ivec4 level, ivec2 pixel) {
    ivec2 at = pixel >> level.x;
    int tile = level.z + at.y * level.y + at.x;
    return ivec2(table_fetch(list_begin_table, tile).x, table_fetch(list_begin_table, tile + 1).x);
}

uvec2 candidate_at(int place) { return table_fetch(candidate_table, place).xy; }

// Long arrays live in buffer textures; where those are too short (TABLE_SHIFT is defined), in 2D textures of 2^TABLE_SHIFT
// columns, row by row. Twin: src/gpu/table.hpp.
#ifdef TABLE_SHIFT
#define float_table sampler2D
#define uint_table usampler2D
#define table_fetch(table, i) texelFetch(table, ivec2((i) & ((1 << TABLE_SHIFT) - 1), (i) >> TABLE_SHIFT), 0)
#else
#define float_table samplerBuffer
#define uint_table usamplerBuffer
#define table_fetch(table, i) texelFetch(table, i)
#endif

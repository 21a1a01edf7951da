// SIMD from the compiler.
#pragma once

// Before a function: compiles versions of it for wide SIMD, among which the loader chooses by the processor, if it can. The bits
// are the same, because without contraction every operation is IEEE 754's. (Sanitizers start too late for this.) For the inner
// loops of cpu, tiles and shade.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define SPHEREVIEW_FOR_EACH_SIMD __attribute__((target_clones("default", "avx2", "arch=x86-64-v4"), flatten))
#else
#define SPHEREVIEW_FOR_EACH_SIMD
#endif

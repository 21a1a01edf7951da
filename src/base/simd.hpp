// SIMD from the compiler.
#pragma once

// Before a function: where the loader can choose among versions of it by the processor at hand, wide SIMD serves those that
// have it. Same bits: without contraction every operation is IEEE 754's, however many at a time. (Sanitizers start too late
// for it.) The inner loops of cpu, tiles and shade use it.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define SPHEREVIEW_FOR_EACH_SIMD __attribute__((target_clones("default", "avx2", "arch=x86-64-v4"), flatten))
#else
#define SPHEREVIEW_FOR_EACH_SIMD
#endif

#include "cpu/idle_threads.hpp"

#include <omp.h>

namespace sphereview {

// GNU's has this part of OpenMP 5 since GCC 9, before it claims that version.
#if (defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 9) || (defined(_OPENMP) && _OPENMP >= 201811)
void end_idle_threads() { omp_pause_resource_all(omp_pause_soft); }
#else
void end_idle_threads() {}
#endif

}  // namespace sphereview

// OpenMP's threads when the parallel work is done.
#pragma once

namespace sphereview {

// Ends the waiting threads, where the library can: GNU's let them spin for milliseconds, which on a busy machine takes the
// processor from the thread that goes on. The next parallel work starts new ones.
void end_idle_threads();

}  // namespace sphereview

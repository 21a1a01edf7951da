// What the process does with memory that it no longer needs.
#pragma once

namespace sphereview {

// From now on blocks of megabytes go back to the system when they are freed, for a process that lives long and whose needs come and
// go. glibc keeps freed blocks of up to 32 MB otherwise; elsewhere this does nothing.
void return_large_blocks();

}  // namespace sphereview

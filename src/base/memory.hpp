// Whether something large fits in memory, asked before it is begun, and giving back what is no longer needed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace sphereview {

// Bytes that this process can still have: what the system has free or can free without swapping, and the limits of its control
// groups and of its address space. Nothing where that cannot be told (only Linux tells).
std::optional<std::uint64_t> available_memory();

// What is left of the limits of its control group (version 2) and of those around it; nothing where they set none, and elsewhere
// than on Linux. `root`: the folder that holds /proc and /sys.
std::optional<std::uint64_t> memory_left_in_groups(const std::string& root = "");

// What is left of a limit on this process's address space (ulimit -v); nothing where there is none.
std::optional<std::uint64_t> address_space_left();

// Throws MemoryError "WHAT 80.0 GB of memory, 3.1 GB are available" when `bytes` are more than that; `what` ends with "need".
// Asks nobody about amounts that any machine has.
void require_memory(std::uint64_t bytes, const std::string& what);

// "3.1 GB", "20 MB"
std::string in_bytes(std::uint64_t bytes);

// From now on blocks of megabytes go back to the system when they are freed, for a process that lives long and whose needs come and
// go. glibc keeps freed blocks of up to 32 MB otherwise; elsewhere this does nothing.
void return_large_blocks();

// Of memory that is reserved and not touched yet: the system may provide it some megabytes at a time. Page by page, it takes longer
// than whoever fills the memory. Elsewhere than on Linux this does nothing.
void prefer_large_pages(void* memory, std::size_t bytes);

}  // namespace sphereview

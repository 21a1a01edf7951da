// Asks whether large work fits in memory before it begins, and gives freed memory back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace sphereview {

// Bytes that this process can still have: what the system can give without swapping, within the limits of control groups and
// address space. Nothing if unknown (only Linux tells).
std::optional<std::uint64_t> available_memory();

// Bytes left of the limits of the process's control group (of version 2) and of its parents; nothing without limits, and on other
// systems than Linux. `root`: the folder that holds /proc and /sys.
std::optional<std::uint64_t> memory_left_in_groups(const std::string& root = "");

// Bytes left of a limit on the address space (ulimit -v); nothing without one.
std::optional<std::uint64_t> address_space_left();

// Throws MemoryError "WHAT 80.0 GB of memory, 3.1 GB are available" if `bytes` are not available; `what` ends with "need". Amounts
// that any machine has always pass.
void require_memory(std::uint64_t bytes, const std::string& what);

// "3.1 GB", "20 MB"
std::string in_bytes(std::uint64_t bytes);

// From now on freed blocks of megabytes go back to the system, for a process that lives long and whose needs vary. Else glibc keeps
// freed blocks of up to 32 MB; elsewhere this does nothing.
void return_large_blocks();

// Lets the system provide untouched memory some megabytes at a time: page by page takes longer than filling the memory. Does
// nothing on other systems than Linux.
void prefer_large_pages(void* memory, std::size_t bytes);

}  // namespace sphereview

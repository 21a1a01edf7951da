// Telling whether what another process left behind is still its own.
#pragma once

#include <filesystem>

namespace sphereview {

// A file that this process holds until the lock's or its own end, however that comes. Other programs may still read and write it.
class FileLock {
public:
    FileLock() = default;
    // Makes the file, for this user alone, where it is missing. Holds nothing where that fails or another has it.
    explicit FileLock(const std::filesystem::path& file);
    ~FileLock();
    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;

    bool holds() const { return handle_ != none; }
    // Whether a process holds the file, this one included. Also where that cannot be told: nobody holds only a file that is
    // missing, or whose lock can be had. What is no regular file is not waited for, and counts as held.
    static bool is_held(const std::filesystem::path& file);

private:
    static constexpr std::intptr_t none = -1;
    std::intptr_t handle_ = none;
};

}  // namespace sphereview

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

    // Whether a process holds the file, this one included. Nobody holds a file that is missing, or whose lock can be had. Nothing
    // can be told of a file that cannot be opened or that is no regular file, which is not waited for, and where the file system
    // cannot lock.
    enum class Holder { nobody, process, unknown };
    static Holder holder_of(const std::filesystem::path& file);

private:
    static constexpr std::intptr_t none = -1;
    std::intptr_t handle_ = none;
};

}  // namespace sphereview

// Tells whether the owner of a file still runs.
#pragma once

#include <filesystem>

namespace sphereview {

// A lock on a file, held until this object or the process ends, however that comes. Other programs may still read and write the
// file.
class FileLock {
public:
    FileLock() = default;
    // Makes the file, for this user alone, if it is missing. Holds nothing if that fails or another process has the lock.
    explicit FileLock(const std::filesystem::path& file);
    ~FileLock();
    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;

    bool holds() const { return handle_ != none; }

    // Who holds the file: a process, this one included, or nobody, also if the file is missing. Unknown if the file cannot be
    // opened or is not regular, or if the file system cannot lock. Never waits.
    enum class Holder { nobody, process, unknown };
    static Holder holder_of(const std::filesystem::path& file);

private:
    static constexpr std::intptr_t none = -1;
    std::intptr_t handle_ = none;
};

}  // namespace sphereview

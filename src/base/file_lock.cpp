#include "base/file_lock.hpp"

#include <utility>

#ifdef _WIN32
#include <windows.h>
#else
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#endif

namespace sphereview {

#ifdef _WIN32

// Opened for nobody else.
FileLock::FileLock(const std::filesystem::path& file)
    : handle_(reinterpret_cast<std::intptr_t>(
          CreateFileW(file.c_str(), GENERIC_WRITE, FILE_SHARE_DELETE, nullptr, OPEN_ALWAYS, FILE_ATTRIBUTE_NORMAL, nullptr))) {}

FileLock::~FileLock() {
    if (holds()) CloseHandle(reinterpret_cast<HANDLE>(handle_));
}

bool FileLock::is_held(const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::exists(file, error) && !FileLock(file).holds();
}

#else

FileLock::FileLock(const std::filesystem::path& file) : handle_(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
    if (holds() && flock(static_cast<int>(handle_), LOCK_EX | LOCK_NB) != 0) *this = FileLock();
}

FileLock::~FileLock() {
    if (holds()) close(static_cast<int>(handle_));
}

bool FileLock::is_held(const std::filesystem::path& file) {
    const int handle = open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (handle < 0) return false;
    // Shared, so that two who ask at once do not take each other for the holder.
    const bool held = flock(handle, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    close(handle);
    return held;
}

#endif

FileLock::FileLock(FileLock&& other) noexcept : handle_(std::exchange(other.handle_, none)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
}

}  // namespace sphereview

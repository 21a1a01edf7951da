#include "base/file_lock.hpp"

#include <utility>

#ifdef _WIN32
#include <windows.h>
#else
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/system_call.hpp"
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

FileLock::Holder FileLock::holder_of(const std::filesystem::path& file) {
    std::error_code ignored;
    const bool missing = std::filesystem::status(file, ignored).type() == std::filesystem::file_type::not_found;
    return missing || FileLock(file).holds() ? Holder::nobody : Holder::process;
}

#else

namespace {

// The handle of the file, or -1 with errno. It waits for nobody: a FIFO is opened at once, and then refused.
int open_at_once(const std::filesystem::path& file, int flags) {
    const int handle = uninterrupted([&] { return open(file.c_str(), flags | O_CLOEXEC | O_NONBLOCK, 0600); });
    struct stat status {};
    if (handle < 0 || (fstat(handle, &status) == 0 && S_ISREG(status.st_mode))) return handle;
    close(handle);
    errno = EINVAL;
    return -1;
}

bool locks(int handle, int operation) {
    return uninterrupted([&] { return flock(handle, operation | LOCK_NB); }) == 0;
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& file) : handle_(open_at_once(file, O_RDWR | O_CREAT)) {
    if (holds() && !locks(static_cast<int>(handle_), LOCK_EX)) *this = FileLock();
}

FileLock::~FileLock() {
    if (holds()) close(static_cast<int>(handle_));
}

FileLock::Holder FileLock::holder_of(const std::filesystem::path& file) {
    const int handle = open_at_once(file, O_RDONLY);
    if (handle < 0) return errno == ENOENT ? Holder::nobody : Holder::unknown;
    // Shared, so that two who ask at once do not take each other for the holder.
    const Holder holder = locks(handle, LOCK_SH) ? Holder::nobody : errno == EWOULDBLOCK ? Holder::process : Holder::unknown;
    close(handle);
    return holder;
}

#endif

FileLock::FileLock(FileLock&& other) noexcept : handle_(std::exchange(other.handle_, none)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
}

}  // namespace sphereview

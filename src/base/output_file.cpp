#include "base/output_file.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <random>
#include <system_error>

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>
#else
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/interrupt.hpp"
#include "base/path.hpp"
#include "base/standard_streams.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& why) {
    throw OutputError((path == standard_stream ? "stdout" : path) + ": cannot be written: " + why);
}

// Of a step that failed just now. Memory that ran out is another kind of error.
[[noreturn]] void fail_by_errno(const std::string& path) {
    if (errno == ENOMEM) throw std::bad_alloc();
    fail(path, errno != 0 ? std::strerror(errno) : "a write error");
}

// Something other than a regular file stands there: it is written into, not replaced.
bool is_special(const fs::path& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status);
}

// The file that `path` leads to, through symbolic links, also dangling ones.
fs::path follow_links(fs::path path) {
    constexpr int most_links = 40;  // as many as Linux follows
    std::error_code error;
    for (int i = 0; i < most_links && fs::is_symlink(fs::symlink_status(path, error)); ++i) {
        const fs::path target = fs::read_symlink(path, error);
        if (error) break;
        path = path.parent_path() / target;
    }
    return path;
}

fs::path hidden_sibling(const fs::path& target) {
    constexpr std::size_t longest_stem = 200;  // names of more than 255 bytes are refused by most file systems
    std::array<char, 32> suffix{};
    std::random_device random;
    std::snprintf(suffix.data(), suffix.size(), ".%08x%08x.tmp", static_cast<unsigned>(random()), static_cast<unsigned>(random()));
    std::string name(1, '.');
    name += text_from(target.filename()).substr(0, longest_stem);
    name += suffix.data();
    return target.parent_path() / path_from(name);
}

// Writes all bytes; false, with errno set, if that fails.
bool write_to_stdout(std::string_view bytes) {
    std::FILE* file = binary(stdout);
    errno = 0;
#ifdef _WIN32
    const bool good = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    return std::fflush(file) == 0 && good;
#else
    if (std::fflush(file) != 0) return false;
    while (!bytes.empty()) {
        const ssize_t count = write(STDOUT_FILENO, bytes.data(), bytes.size());
        if (count >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            pollfd ready{STDOUT_FILENO, POLLOUT, 0};  // whoever has the other end made it non-blocking
            if (poll(&ready, 1, -1) < 0 && errno != EINTR) return false;
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
#endif
}

// A new file for writing, which nobody may read who could not read `old`; null, with errno set, if there can be none.
std::FILE* create(const fs::path& path, const fs::file_status& old) {
    errno = 0;
#ifdef _WIN32
    static_cast<void>(old);
    // Not fopen() with "x", which older run-time libraries there do not know.
    const int handle = _wopen(path.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
    return handle < 0 ? nullptr : _fdopen(handle, "wb");
#else
    const auto mode = fs::exists(old) ? static_cast<mode_t>(old.permissions() & fs::perms::all) | S_IWUSR : mode_t{0666};
    const int handle = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    std::FILE* file = handle < 0 ? nullptr : fdopen(handle, "wb");
    if (file == nullptr && handle >= 0) {
        close(handle);
        unlink(path.c_str());
        errno = ENOMEM;  // what else fdopen() can lack
    }
    return file;
#endif
}

#ifndef _WIN32
// File systems without such a thing say that it is invalid.
bool sync(int handle) {
#ifdef F_FULLFSYNC
    if (fcntl(handle, F_FULLFSYNC) == 0) return true;
#endif
    return fsync(handle) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}
#endif

bool is_on_disk(std::FILE* file) {
#ifdef _WIN32
    return _commit(_fileno(file)) == 0;
#else
    return sync(fileno(file));
#endif
}

// The names in `folder` are on the disk when this returns true. Windows takes care of its names itself.
bool are_names_on_disk(const fs::path& folder) {
#ifdef _WIN32
    static_cast<void>(folder);
    return true;
#else
    const int handle = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle < 0) return errno == EACCES;  // a folder may be written to and not be read
    const bool done = sync(handle);
    close(handle);
    return done;
#endif
}

// Writes all bytes and closes; false, with errno set, if any step fails.
bool write_and_close(std::FILE* file, std::string_view bytes, Durability durability) {
    errno = 0;
    bool good = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    good = std::fflush(file) == 0 && good;
    good = good && (durability == Durability::in_system || is_on_disk(file));
    const int first_error = errno;
    const bool closed = std::fclose(file) == 0;
    if (!good) errno = first_error;
    return good && closed;
}

void replace(const std::string& path, std::string_view bytes, Durability durability) {
    const fs::path target = follow_links(path_from(path));
    const fs::path temporary = hidden_sibling(target);
    const Unfinished unfinished;
    const auto give_up = [&](int error) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        errno = error;
        fail_by_errno(path);
    };

    std::error_code error;
    const fs::file_status old = fs::status(target, error);
    std::FILE* file = create(temporary, old);
    if (file == nullptr) fail_by_errno(path);
    if (!write_and_close(file, bytes, durability)) give_up(errno);
    if (fs::exists(old)) fs::permissions(temporary, old.permissions(), error);
    fs::rename(temporary, target, error);
    if (error) give_up(error.default_error_condition().value());
    if (durability == Durability::on_disk && !are_names_on_disk(target.parent_path())) fail_by_errno(path);
}

}  // namespace

void write_output(const std::string& path, std::string_view bytes, Durability durability) {
    check_output(path);
    if (path == standard_stream) {
        if (!write_to_stdout(bytes)) fail_by_errno(path);
    } else if (is_special(path_from(path))) {
        std::FILE* file = std::fopen(path.c_str(), "wb");
        if (file == nullptr || !write_and_close(file, bytes, Durability::in_system)) fail_by_errno(path);
    } else {
        replace(path, bytes, durability);
    }
}

void check_output(const std::string& path) {
    if (path == standard_stream) return;
    if (path.empty()) fail("''", "it has no name");
    std::error_code error;
    const fs::path target = follow_links(path_from(path));
    const fs::file_status status = fs::status(target, error);
    if (error && error != std::errc::no_such_file_or_directory) fail(path, error.message());
    if (fs::is_directory(status)) fail(path, "it is a folder");
    if (!target.has_filename()) fail(path, "it names a folder");
    if (fs::is_regular_file(status)) {
        // A rename would replace a file that its owner has protected.
        std::FILE* file = std::fopen(text_from(target).c_str(), "r+b");
        if (file == nullptr) fail_by_errno(path);
        std::fclose(file);
    } else if (!fs::exists(status)) {
        const fs::path folder = target.parent_path().empty() ? fs::path(".") : target.parent_path();
        if (!fs::exists(folder, error)) fail(path, "the folder " + text_from(folder) + " does not exist");
        if (!fs::is_directory(folder, error)) fail(path, text_from(folder) + " is not a folder");
    }
}

std::string file_identity(const std::string& path) {
    if (path == standard_stream || is_special(path_from(path))) return "";
    std::error_code error;
    const fs::path absolute = fs::absolute(follow_links(path_from(path)), error);
    const fs::path canonical = fs::weakly_canonical(absolute, error);
    return text_from(error ? absolute.lexically_normal() : canonical);
}

}  // namespace sphereview

#include "base/output_file.hpp"

#include <algorithm>
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
#include <windows.h>
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
#include "base/system_call.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& why, std::errc error) {
    throw OutputError(path == standard_stream ? "stdout" : path, why, static_cast<int>(error));
}

// Throws for a step that has just failed. A lack of memory is another kind of error.
[[noreturn]] void fail_by_errno(const std::string& path) {
    if (errno == ENOMEM) throw std::bad_alloc();
    if (errno == 0) fail(path, "a write error", std::errc::io_error);
    fail(path, std::strerror(errno), static_cast<std::errc>(errno));
}

// The error as an errno, also on systems with other numbers.
int errno_of(const std::error_code& error) { return error.default_error_condition().value(); }

[[noreturn]] void fail_by(const std::string& path, const std::error_code& error) {
    if (error == std::errc::not_enough_memory) throw std::bad_alloc();
    fail(path, error.message(), static_cast<std::errc>(errno_of(error)));
}

// Something other than a regular file stands there: it is written into, not replaced.
bool is_special(const fs::file_status& status) { return fs::exists(status) && !fs::is_regular_file(status); }

// The file that `path` leads to, through symbolic links, also dangling ones. `error`: why that cannot be told.
fs::path follow_links(fs::path path, std::error_code& error) {
    constexpr int most_links = 40;  // as many as Linux follows
    for (int i = 0; i < most_links; ++i) {
        const fs::file_status status = fs::symlink_status(path, error);
        if (status.type() == fs::file_type::none) break;
        error.clear();  // nothing stands there: no fault
        if (!fs::is_symlink(status)) break;
        const fs::path target = fs::read_symlink(path, error);
        if (error) break;
        path = path.parent_path() / target;
    }
    return path;
}

// Where an output goes, and what stands there now.
struct Target {
    fs::path path;
    fs::file_status status;
};

// Throws when that cannot be told: a guess could replace a link or a device, or let others read what was private.
Target target_of(const std::string& path) {
    if (is_device_name(path_from(path))) return {path_from(path), fs::file_status(fs::file_type::character)};
    std::error_code error;
    Target target;
    target.path = follow_links(path_from(path), error);
    if (error) fail_by(path, error);
    target.status = fs::status(target.path, error);
    // check() reports a path below a file that is no folder.
    if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory) fail_by(path, error);
    return target;
}

// Not a file without a name (O_TMPFILE): a link to it cannot replace a file that stands there.
fs::path hidden_sibling(const fs::path& target) {
    constexpr std::size_t longest_stem = 200;  // names of more than 255 bytes are refused by most file systems
    std::array<char, 32> suffix{};
    std::random_device random;
    std::snprintf(suffix.data(), suffix.size(), ".%08x%08x.tmp", static_cast<unsigned>(random()), static_cast<unsigned>(random()));
    std::string stem = text_from(target.filename());
    std::size_t length = std::min(stem.size(), longest_stem);
    while (length > 0 && length < stem.size() && (static_cast<unsigned char>(stem[length]) & 0xC0U) == 0x80U)
        --length;  // whole characters
    stem.resize(length);
    std::string name = "." + stem;
    name += suffix.data();
    return target.parent_path() / path_from(name);
}

#ifdef _WIN32

// Writes all bytes; false, with errno set, if that fails.
bool write_all(std::FILE* file, std::string_view bytes) {
    const bool good = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    return std::fflush(file) == 0 && good;
}

bool write_to_stdout(std::string_view bytes) {
    std::FILE* file = binary(stdout);
    errno = 0;
    const bool good = write_all(file, bytes);
    // The library has no number of its own for a pipe whose reader is gone, and it may clear what GetLastError() would tell.
    const auto handle = reinterpret_cast<HANDLE>(_get_osfhandle(_fileno(file)));
    if (!good && errno == EINVAL && GetFileType(handle) == FILE_TYPE_PIPE) errno = EPIPE;
    return good;
}

using Opened = std::FILE*;
constexpr Opened not_opened = nullptr;

// A new file for writing, and one that may stand there already; not_opened, with errno set, if there can be none.
Opened create(const fs::path& path, const fs::file_status&) {
    // Not fopen() with "x", which older run-time libraries there do not know.
    const int handle = _wopen(path.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
    std::FILE* file = handle < 0 ? nullptr : _fdopen(handle, "wb");
    if (file == nullptr && handle >= 0) {
        _close(handle);
        _wremove(path.c_str());
        errno = ENOMEM;  // what else _fdopen() can lack
    }
    return file;
}
Opened open_special(const std::string& path) { return open_file(path, "wb"); }
Opened open_written(const fs::path& path) { return open_file(text_from(path), "r+b"); }
Opened opened(std::FILE* file) { return file; }
bool close_opened(Opened file) { return std::fclose(file) == 0; }

// Puts on the disk what was written; false, with errno set, if that fails.
bool sync(Opened file) { return _commit(_fileno(file)) == 0; }

#else

// Writes all bytes, and waits where the other end made a pipe non-blocking; false, with errno set, if that fails.
bool write_all(int handle, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = uninterrupted([&] { return write(handle, bytes.data(), bytes.size()); });
        if (count >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            pollfd ready{handle, POLLOUT, 0};
            if (uninterrupted([&] { return poll(&ready, 1, -1); }) < 0) return false;
        } else {
            return false;
        }
    }
    return true;
}

bool write_to_stdout(std::string_view bytes) { return std::fflush(stdout) == 0 && write_all(STDOUT_FILENO, bytes); }

using Opened = int;
constexpr Opened not_opened = -1;

// A new file for writing, which nobody may read who could not read `old`; not_opened, with errno set, if there can be none.
Opened create(const fs::path& path, const fs::file_status& old) {
    const auto mode = fs::exists(old) ? static_cast<mode_t>(old.permissions() & fs::perms::all) | S_IWUSR : mode_t{0666};
    return uninterrupted([&] { return open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode); });
}

Opened open_special(const std::string& path) {
    return uninterrupted([&] { return open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC); });
}

// A file that another program has written.
Opened open_written(const fs::path& path) {
    return uninterrupted([&] { return open(path.c_str(), O_WRONLY | O_CLOEXEC); });
}

// Not through the library's buffer, which forgets what a signal kept it from writing.
Opened opened(std::FILE* file) { return fileno(file); }

// Interrupted, the handle is closed all the same.
bool close_opened(Opened handle) { return close(handle) == 0 || errno == EINTR; }

// File systems without such a thing say that it is invalid.
bool sync(Opened handle) {
#ifdef F_FULLFSYNC
    if (fcntl(handle, F_FULLFSYNC) == 0) return true;
#endif
    return uninterrupted([&] { return fsync(handle); }) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

#endif

// Writes all bytes; false, with errno set, if any step fails.
bool write_by(Durability durability, Opened file, std::string_view bytes) {
    errno = 0;
    return write_all(file, bytes) && (durability == Durability::in_system || sync(file));
}

// The same, and closes.
bool write_and_close(Opened file, std::string_view bytes, Durability durability) {
    const bool good = write_by(durability, file, bytes);
    const int first_error = errno;
    const bool closed = close_opened(file);
    if (!good) errno = first_error;
    return good && closed;
}

// The names in `folder` are on the disk when this returns true. Windows takes care of its names itself.
bool are_names_on_disk(const fs::path& folder) {
#ifdef _WIN32
    static_cast<void>(folder);
    return true;
#else
    const int handle =
        uninterrupted([&] { return open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); });
    if (handle < 0) return errno == EACCES;  // a folder may be written to and not be read
    const bool done = sync(handle);
    close(handle);
    return done;
#endif
}

// With those above it, for the output `path`.
void make_folder(const std::string& path, const fs::path& folder, Durability durability) {
    std::error_code error;
    if (folder.empty() || fs::is_directory(folder, error)) return;
    make_folder(path, folder.parent_path(), durability);
    if (!fs::create_directory(folder, error) && error) fail_by(path, error);
    if (durability == Durability::on_disk && !are_names_on_disk(folder.parent_path())) fail_by_errno(path);
}

// Removes a file that could not become the output `path`, and throws.
[[noreturn]] void give_up(const std::string& path, const fs::path& temporary, int error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    errno = error;
    fail_by_errno(path);
}

// Gives a file that is written the name of the output, and the mode of what stands there.
void rename_to(const std::string& path, const Target& target, const fs::path& temporary, Durability durability) {
    std::error_code error;
    if (fs::exists(target.status)) {
        fs::permissions(temporary, target.status.permissions(), error);
        // Some file systems refuse to set what every file of theirs has anyway.
        std::error_code untold;
        if (error && fs::status(temporary, untold).permissions() != target.status.permissions()) {
            give_up(path, temporary, errno_of(error));
        }
    }
    fs::rename(temporary, target.path, error);
    if (error) give_up(path, temporary, errno_of(error));
    if (durability == Durability::on_disk && !are_names_on_disk(target.path.parent_path())) fail_by_errno(path);
}

// A new file beside the output, with the bytes in it. The caller holds an Unfinished.
fs::path written_beside(const std::string& path, const Target& target, std::string_view bytes, Durability durability) {
    fs::path temporary = hidden_sibling(target.path);
    errno = 0;
    const Opened file = create(temporary, target.status);
    if (file == not_opened) fail_by_errno(path);
    if (!write_and_close(file, bytes, durability)) give_up(path, temporary, errno);
    return temporary;
}

void replace(const std::string& path, const Target& target, std::string_view bytes, Durability durability) {
    const Unfinished unfinished;
    rename_to(path, target, written_beside(path, target, bytes, durability), durability);
}

// Throws OutputError when that plainly cannot become an output.
void check(const std::string& path, const Target& target, MissingFolder missing) {
    if (fs::is_directory(target.status)) fail(path, "it is a folder", std::errc::is_a_directory);
    if (!target.path.has_filename()) fail(path, "it names a folder", std::errc::is_a_directory);
    if (fs::is_regular_file(target.status)) {
        // A rename would replace a file that its owner has protected.
        std::FILE* file = open_file(text_from(target.path), "r+b");
        if (file == nullptr) fail_by_errno(path);
        std::fclose(file);
    } else if (!fs::exists(target.status)) {
        const auto above = [](const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); };
        fs::path folder = above(target.path);
        std::error_code error;
        fs::file_status status = fs::status(folder, error);
        while (missing == MissingFolder::made && status.type() == fs::file_type::not_found && folder != above(folder)) {
            folder = above(folder);
            status = fs::status(folder, error);
        }
        if (status.type() == fs::file_type::not_found) {
            fail(path, "the folder " + text_from(folder) + " does not exist", std::errc::no_such_file_or_directory);
        }
        if (error) fail_by(path, error);
        if (!fs::is_directory(status)) fail(path, text_from(folder) + " is not a folder", std::errc::not_a_directory);
    }
}

// As check_output(), and returns the target.
Target checked_target_of(const std::string& path, MissingFolder missing) {
    if (path.empty()) fail("''", "it has no name", std::errc::no_such_file_or_directory);
    Target target = target_of(path);
    check(path, target, missing);
    return target;
}

// The same, and throws OutputError where something other than a regular file stands.
Target regular_target_of(const std::string& path) {
    Target target = checked_target_of(path, MissingFolder::refused);
    if (is_special(target.status)) fail(path, "it is no regular file", std::errc::invalid_argument);
    return target;
}

}  // namespace

bool is_device_name([[maybe_unused]] const fs::path& path) {
#ifdef _WIN32
    constexpr DWORD longest = 32768;
    std::wstring full(longest, L'\0');
    full.resize(std::min(longest, GetFullPathNameW(path.c_str(), longest, full.data(), nullptr)));
    return full.starts_with(L"\\\\.\\");
#else
    return false;
#endif
}

void write_output(const std::string& path, std::string_view bytes, Durability durability, MissingFolder missing) {
    if (path == standard_stream) {
        if (!write_to_stdout(bytes)) fail_by_errno(path);
        return;
    }
    const Target target = checked_target_of(path, missing);
    if (is_special(target.status)) {
        const Opened file = open_special(path);
        if (file == not_opened || !write_and_close(file, bytes, Durability::in_system)) fail_by_errno(path);
    } else {
        if (missing == MissingFolder::made) make_folder(path, target.path.parent_path(), durability);
        replace(path, target, bytes, durability);
    }
}

void write_regular_file(const std::string& path, std::string_view bytes, Durability durability) {
    replace(path, regular_target_of(path), bytes, durability);
}

bool append(std::FILE* file, std::string_view bytes, Durability durability) { return write_by(durability, opened(file), bytes); }

OutputPlace::OutputPlace(const std::string& path) : path_(path) {
    const Target target = regular_target_of(path);
    target_ = target.path;
    const Unfinished unfinished;
    temporary_ = written_beside(path, target, {}, Durability::in_system);
}

OutputPlace::~OutputPlace() {
    std::error_code ignored;
    if (!taken_) fs::remove(temporary_, ignored);
}

std::string OutputPlace::temporary() const { return text_from(temporary_); }

void OutputPlace::take(Durability durability) {
    const Unfinished unfinished;
    errno = 0;
    // Another program's file is on the disk when this one's handle says so.
    const Opened file = durability == Durability::on_disk ? open_written(temporary_) : not_opened;
    if (durability == Durability::on_disk && (file == not_opened || !write_and_close(file, {}, durability))) fail_by_errno(path_);
    std::error_code error;
    rename_to(path_, {target_, fs::status(target_, error)}, temporary_, durability);
    taken_ = true;
}

void check_output(const std::string& path, MissingFolder missing) {
    if (path != standard_stream) checked_target_of(path, missing);
}

std::string file_identity(const std::string& path, FileUse use) {
    std::error_code error;
    if (path == standard_stream || is_device_name(path_from(path)) || is_special(fs::status(path_from(path), error))) return "";
    const fs::path target = follow_links(path_from(path), error);
    // An input is as far as its links could be followed: reading it fails then, and says why.
    if (error && use == FileUse::output) fail_by(path, error);
    error.clear();
    const fs::path absolute = is_network_name(target) ? target : fs::absolute(target, error);
    if (error) fail(path, "the folder that it is in cannot be told: " + error.message(), static_cast<std::errc>(errno_of(error)));
    const fs::path canonical = fs::weakly_canonical(absolute, error);
    return text_from(error ? normal_path(absolute) : canonical);
}

}  // namespace sphereview

#include "base/output_file.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>
#include <system_error>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/interrupt.hpp"
#include "base/standard_streams.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& why) {
    throw OutputError((path == standard_stream ? "stdout" : path) + ": cannot be written: " + why);
}

std::string last_error() { return errno != 0 ? std::strerror(errno) : "a write error"; }

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
    name += target.filename().string().substr(0, longest_stem);
    name += suffix.data();
    return target.parent_path() / name;
}

// Writes all bytes and closes; false, with errno set, if any step fails. Standard output stays open.
bool write_and_close(std::FILE* file, std::string_view bytes) {
    errno = 0;
    bool good = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    good = std::fflush(file) == 0 && good;
    if (file == stdout) return good;
    const int first_error = errno;
    const bool closed = std::fclose(file) == 0;
    if (!good) errno = first_error;
    return good && closed;
}

void replace(const std::string& path, std::string_view bytes) {
    const fs::path target = follow_links(path);
    const fs::path temporary = hidden_sibling(target);
    const Unfinished unfinished;
    const auto give_up = [&](const std::string& why) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        fail(path, why);
    };

    std::FILE* file = std::fopen(temporary.string().c_str(), "wbx");
    if (file == nullptr) fail(path, last_error());
    if (!write_and_close(file, bytes)) give_up(last_error());

    std::error_code error;
    const fs::file_status old = fs::status(target, error);
    if (fs::exists(old)) fs::permissions(temporary, old.permissions(), error);
    fs::rename(temporary, target, error);
    if (error) give_up(error.message());
}

}  // namespace

void write_output(const std::string& path, std::string_view bytes) {
    check_output(path);
    if (path == standard_stream) {
        if (!write_and_close(binary_stdout(), bytes)) fail(path, last_error());
    } else if (is_special(path)) {
        std::FILE* file = std::fopen(path.c_str(), "wb");
        if (file == nullptr || !write_and_close(file, bytes)) fail(path, last_error());
    } else {
        replace(path, bytes);
    }
}

void check_output(const std::string& path) {
    if (path == standard_stream) return;
    if (path.empty()) fail("''", "it has no name");
    std::error_code error;
    const fs::path target = follow_links(path);
    const fs::file_status status = fs::status(target, error);
    if (error && error != std::errc::no_such_file_or_directory) fail(path, error.message());
    if (fs::is_directory(status)) fail(path, "it is a folder");
    if (!target.has_filename()) fail(path, "it names a folder");
    if (fs::is_regular_file(status)) {
        // A rename would replace a file that its owner has protected.
        std::FILE* file = std::fopen(target.string().c_str(), "r+b");
        if (file == nullptr) fail(path, last_error());
        std::fclose(file);
    } else if (!fs::exists(status)) {
        const fs::path folder = target.parent_path().empty() ? fs::path(".") : target.parent_path();
        if (!fs::exists(folder, error)) fail(path, "the folder " + folder.string() + " does not exist");
        if (!fs::is_directory(folder, error)) fail(path, folder.string() + " is not a folder");
    }
}

std::string file_identity(const std::string& path) {
    if (path == standard_stream || is_special(path)) return "";
    std::error_code error;
    const fs::path absolute = fs::absolute(follow_links(path), error);
    const fs::path canonical = fs::weakly_canonical(absolute, error);
    return (error ? absolute.lexically_normal() : canonical).string();
}

}  // namespace sphereview

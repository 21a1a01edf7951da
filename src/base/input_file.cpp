#include "base/input_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "base/error.hpp"
#include "base/standard_streams.hpp"

#ifndef _WIN32
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace sphereview {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_streamed = std::size_t{1} << 31;

}  // namespace

InputFile::InputFile(const std::string& path, Content content) : name_(path == standard_stream ? "stdin" : path) {
    const bool from_stdin = path == standard_stream;
    const auto fail = [&](const std::string& why) -> void { throw InputError(name_ + ": cannot be read: " + why); };

    std::error_code ignored;
    if (!from_stdin && fs::is_directory(path, ignored)) fail("it is a folder; expected a file");
    std::FILE* file = from_stdin ? binary_stdin() : std::fopen(path.c_str(), "rb");
    if (file == nullptr) fail(std::strerror(errno));
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> closer(from_stdin ? nullptr : file, &std::fclose);

    const bool regular = !from_stdin && fs::is_regular_file(path, ignored);
    std::size_t capacity = 1 << 16;
    if (regular) {
        const auto size = fs::file_size(path, ignored);
        if (!ignored) capacity = static_cast<std::size_t>(size) + 1;  // one more, so that the end is met without growing
    }
    data_ = std::make_unique_for_overwrite<char[]>(capacity);
    while (true) {
        if (size_ == capacity) {
            auto grown = std::make_unique_for_overwrite<char[]>(capacity * 2);
            std::copy_n(data_.get(), size_, grown.get());
            data_ = std::move(grown);
            capacity *= 2;
        }
        errno = 0;
        const std::size_t count = std::fread(data_.get() + size_, 1, capacity - size_, file);
        if (count == 0) {
            if (std::ferror(file) != 0) fail(errno != 0 ? std::strerror(errno) : "a read error");
            return;
        }
        const bool whole = regular || content == Content::binary;
        const char* zero = whole ? nullptr : static_cast<const char*>(std::memchr(data_.get() + size_, 0, count));
        size_ += count;
        if (zero != nullptr) {
            size_ = static_cast<std::size_t>(zero - data_.get()) + 1;
            return;
        }
        if (!regular && size_ > most_streamed) fail("it does not end within 2 GiB");
    }
}

#ifdef _WIN32
void InputFile::release_first(std::size_t) {}
#else
void InputFile::release_first(std::size_t count) {
    // Whole pages inside the bytes alone; what the allocator keeps around them is left.
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const auto data = reinterpret_cast<std::uintptr_t>(data_.get());
    const std::uintptr_t first = (data + page - 1) / page * page;
    const std::uintptr_t last = (data + std::min(count, size_)) / page * page;
    if (last > first) madvise(reinterpret_cast<void*>(first), last - first, MADV_DONTNEED);
}
#endif

}  // namespace sphereview

#include "base/input_file.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/path.hpp"
#include "base/standard_streams.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_streamed = std::size_t{1} << 31;
constexpr std::size_t most_in_one_read = std::size_t{1} << 22;  // so that a watcher is called often

int leave_open(std::FILE*) { return 0; }

// `error`: errno, or 0 where the system gives none.
[[noreturn]] void fail_to_read(const std::string& name, int error) {
    if (error == ENOMEM) throw std::bad_alloc();
    throw ReadError(name, error != 0 ? std::strerror(error) : "a read error", error != 0 ? error : EIO);
}

// "; did you mean 'NAME'?" for another file of the folder; "" where none is called nearly so.
std::string similar_file(const std::string& path) {
    constexpr std::size_t shortest_name = 6;  // of one letter and an ending every other is near: then only the ending may differ
    constexpr std::size_t most_names = 10'000;
    const fs::path typed = path_from(path);
    const std::string name = text_from(typed.filename());
    std::vector<std::string> names;
    std::error_code error;
    fs::directory_iterator entries(typed.has_parent_path() ? typed.parent_path() : fs::path("."), error);
    for (; !error && entries != fs::directory_iterator() && names.size() < most_names; entries.increment(error)) {
        const fs::path& file = entries->path();
        if (name.size() >= shortest_name || file.stem() == typed.stem()) names.push_back(text_from(file.filename()));
    }
    return did_you_mean(name, names);
}

// Up to `most` bytes; 0 only at the file's end.
std::size_t read_bytes(std::FILE* file, const std::string& name, char* to, std::size_t most) {
    while (true) {
        errno = 0;
        const std::size_t count = std::fread(to, 1, most, file);
        if (std::ferror(file) == 0) return count;
        if (errno != EINTR) fail_to_read(name, errno);
        std::clearerr(file);  // a signal interrupted it
        if (count > 0) return count;
    }
}

}  // namespace

InputStream::InputStream(const std::string& path, Content content)
    : name_(path == standard_stream ? "stdin" : path), file_(nullptr, &leave_open), content_(content) {
    const bool from_stdin = path == standard_stream;
    std::error_code ignored;
    if (!from_stdin && fs::is_directory(path_from(path), ignored))
        throw ReadError(name_, "it is a folder; expected a file", EISDIR);
    std::FILE* file = from_stdin ? binary(stdin) : open_file(path, "rb");
    if (file == nullptr) {
        const int error = errno;
        if (error == ENOENT) throw ReadError(name_, std::strerror(error) + similar_file(path), error);
        fail_to_read(name_, error);
    }
    file_ = {file, from_stdin ? &leave_open : &std::fclose};

    const bool regular = !from_stdin && fs::is_regular_file(path_from(path), ignored);
    ends_at_zero_ = !regular && content == Content::text;
    if (!regular) return;
    const auto size = fs::file_size(path_from(path), ignored);
    if (ignored || size == 0) return;
    may_be_endless_ = false;
    look_for_gzip();
    if (gunzip_) {
        packed_size_ = size;
    } else {
        size_ = static_cast<std::size_t>(size);
    }
}

std::optional<double> InputStream::unpacked_part() const {
    if (packed_size_ == 0) return std::nullopt;
    // One that grows meanwhile is read on.
    return std::min(static_cast<double>(gunzip_->packed_size()) / static_cast<double>(packed_size_), 1.0);
}

void InputStream::drop_first(std::size_t count) {
    assert(count <= end_ - begin_);
    begin_ += count;
}

std::uint64_t InputStream::nearest_before(std::uint64_t offset) const {
    if (!gunzip_) return offset;
    return places_ ? places_->nearest(offset).unpacked : 0;
}

void InputStream::go_to(std::uint64_t place) {
    assert(is_regular());
    const GzipPlace packed = gunzip_ && places_ ? places_->nearest(place) : GzipPlace{};
    const std::uint64_t offset = gunzip_ ? packed.packed - (packed.bits > 0 ? 1 : 0) : place;
#ifdef _WIN32
    const bool moved = _fseeki64(file_.get(), static_cast<long long>(offset), SEEK_SET) == 0;
#else
    const bool moved = fseeko(file_.get(), static_cast<off_t>(offset), SEEK_SET) == 0;
#endif
    if (!moved) fail_to_read(name_, errno);
    if (gunzip_) {
        gunzip_ = std::make_unique<Gunzip>(name_, packed, packed_source());
        gunzip_->remember_places(places_);
    }
    head_.clear();
    begin_ = end_ = 0;
    ended_ = false;
}

void InputStream::remember_places(GzipPlaces places) {
    if (!gunzip_ || !is_regular()) return;
    places_ = std::make_shared<GzipPlaces>(std::move(places));
    gunzip_->remember_places(places_);
}

// Not by `this`: a stream can be moved.
Gunzip::Source InputStream::packed_source() const {
    return [file = file_.get(), name = name_](char* to, std::size_t most) { return read_bytes(file, name, to, most); };
}

void InputStream::make_room(std::size_t capacity) {
    if (capacity <= capacity_) {
        std::memmove(data_.get(), data_.get() + begin_, end_ - begin_);
    } else {
        require_memory(capacity, name_ + ": its bytes need");
        auto grown = std::make_unique_for_overwrite<char[]>(capacity);
        std::copy_n(data_.get() + begin_, end_ - begin_, grown.get());
        data_ = std::move(grown);
        capacity_ = capacity;
    }
    end_ -= begin_;
    begin_ = 0;
}

// Reads the first bytes, once. Of a pipe only when they are wanted: opening it must not wait.
void InputStream::look_for_gzip() {
    looked_for_gzip_ = true;
    if (content_ != Content::text) return;
    std::array<char, gzip_magic.size()> head{};
    head_.assign(head.data(), read_bytes(file_.get(), name_, head.data(), head.size()));
    if (head_ != gzip_magic) return;
    gunzip_ = std::make_unique<Gunzip>(name_, head_, packed_source());
    head_.clear();
}

// Up to `most` bytes of the text; 0 only at its end.
std::size_t InputStream::read_text(char* to, std::size_t most) {
    if (!looked_for_gzip_) look_for_gzip();
    if (gunzip_) return gunzip_->read(to, most);
    if (head_.empty()) return read_bytes(file_.get(), name_, to, most);
    const std::size_t count = std::min(most, head_.size());
    std::copy_n(head_.data(), count, to);
    head_.erase(0, count);
    return count;
}

void InputStream::fill(std::size_t most) {
    if (ended_ || end_ - begin_ >= most) return;
    make_room(most);
    while (end_ < most) {
        const std::size_t count = read_text(data_.get() + end_, std::min(most - end_, most_in_one_read));
        if (count == 0) {
            ended_ = true;
            return;
        }
        read_ += count;
        if (watcher_) watcher_(read_);
        const void* zero = ends_at_zero_ ? std::memchr(data_.get() + end_, 0, count) : nullptr;
        end_ += count;
        if (zero != nullptr) {
            end_ = static_cast<std::size_t>(static_cast<const char*>(zero) - data_.get()) + 1;
            ended_ = true;
            return;
        }
    }
}

void InputStream::fill() {
    // One more than the size, so that the end is met without growing.
    fill(size_ ? *size_ + 1 : std::size_t{1} << 16);
    while (!ended_) {
        if (may_be_endless_ && bytes().size() > most_streamed) throw ReadError(name_, "it does not end within 2 GiB", EFBIG);
        fill(2 * bytes().size());
    }
}

}  // namespace sphereview

// Reading input files: whole, or front to back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/gunzip.hpp"
#include "base/gzip_places.hpp"

namespace sphereview {

// The path that stands for standard input (as an input) and standard output (as an output).
inline constexpr std::string_view standard_stream = "-";

// What a file holds: of a text, gzip is unpacked, and reading of a device or pipe ends at a zero byte.
enum class Content { text, binary };

// A file, device or pipe read front to back; only a window of it is in memory. The file is read, not mapped: an editor that
// truncates a mapped file kills the reader with SIGBUS. A text that is packed with gzip is unpacked on the way (base/gunzip.hpp).
class InputStream {
public:
    // Opens `path`, or standard input for "-". Throws InputError when it is missing, a folder or unreadable.
    // A text from a device or pipe ends with its first zero byte, which no text holds (/dev/zero has no end).
    explicit InputStream(const std::string& path, Content content = Content::text);

    // The name in messages: the path as given, or "stdin".
    const std::string& name() const { return name_; }
    // A regular file's size in bytes when it was opened. Nothing for a packed text, and where the system hides the size, as in
    // /proc.
    std::optional<std::size_t> size() const { return size_; }
    // The part of a packed regular file that was unpacked so far, 0..1; nothing for other files.
    std::optional<double> unpacked_part() const;
    // Whether `path` leads to a regular file, which another stream can read from the beginning.
    bool is_regular() const { return !may_be_endless_; }

    // The window: the bytes that were read and not dropped.
    std::string_view bytes() const { return {data_.get() + begin_, end_ - begin_}; }
    // Whether nothing follows the window.
    bool ended() const { return ended_; }

    void drop_first(std::size_t count);
    // The nearest place before `offset` from which a regular file can be read, in bytes of the text. In a packed text these are the
    // remembered places and the beginning.
    std::uint64_t nearest_before(std::uint64_t offset) const;
    // Empties the window and goes on at a place that nearest_before() gives. Throws InputError.
    void go_to(std::uint64_t place);
    // From now on remembers places of a packed text, for go_to(). `places`: those that an earlier reader of the file remembered, if
    // any. Does nothing for other files.
    void remember_places(GzipPlaces places = GzipPlaces());
    // The remembered places; null where none are remembered.
    const GzipPlaces* places() const { return places_.get(); }
    // From now on calls `watcher` with the number of bytes read so far, at least every 4 MB. What it throws ends the reading.
    void watch(std::function<void(std::size_t)> watcher) { watcher_ = std::move(watcher); }
    // Reads on until the window holds `most` bytes or the input ends. What bytes() gave before is void. Throws InputError,
    // also when a packed text is damaged or expands too far, and MemoryError when the window cannot fit.
    void fill(std::size_t most);
    // Widens the window to all that is left. Throws as above, also when a device or pipe does not end within 2 GiB.
    void fill();

private:
    void make_room(std::size_t capacity);
    void look_for_gzip();
    Gunzip::Source packed_source() const;
    std::size_t read_text(char* to, std::size_t most);

    std::string name_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    std::optional<std::size_t> size_{};
    std::uintmax_t packed_size_ = 0;  // of a packed regular file
    bool may_be_endless_ = true;
    Content content_;
    bool ends_at_zero_ = false;
    bool looked_for_gzip_ = false;
    std::string head_{};                // of the file; read to look at, and not taken yet
    std::unique_ptr<Gunzip> gunzip_{};  // of a packed text
    std::shared_ptr<GzipPlaces> places_{};
    std::function<void(std::size_t)> watcher_{};
    std::size_t read_ = 0;  // bytes, in all
    bool ended_ = false;
    std::unique_ptr<char[]> data_{};  // not a vector: its bytes would be cleared before they are read
    std::size_t capacity_ = 0;
    std::size_t begin_ = 0;  // of the window
    std::size_t end_ = 0;
};

// A whole file in memory.
class InputFile {
public:
    // As InputStream, and reads all of it.
    explicit InputFile(const std::string& path, Content content = Content::text) : stream_(path, content) { stream_.fill(); }

    const std::string& name() const { return stream_.name(); }
    std::string_view bytes() const { return stream_.bytes(); }

private:
    InputStream stream_;
};

}  // namespace sphereview

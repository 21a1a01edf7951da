// The file: a line that names it, a line with the SHA-256 of what follows, and then whole numbers, seven bits a byte, the low ones
// first, and texts, each behind its length.
#include "formats/frame_index.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/path.hpp"
#include "base/sha256.hpp"
#include "base/user_folders.hpp"

namespace sphereview {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view head = "sphereview frames 1\n";
constexpr std::string_view ending = ".frames";
constexpr std::size_t sum_size = 64;
constexpr std::size_t sampled_bytes = std::size_t{1} << 12;  // at each end of a file
constexpr std::size_t longest_index = std::size_t{1} << 25;
constexpr std::size_t most_indexes = 64;
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 28;  // of all indexes
constexpr std::chrono::seconds moment{2};                     // more than any file system rounds its times to

fs::path index_folder() {
    const fs::path folder = state_folder();
    return folder.empty() ? fs::path() : folder / "frames";
}

// Empty where the user has no folder.
fs::path index_file(const FileStamp& stamp) {
    const fs::path folder = index_folder();
    return folder.empty() ? fs::path() : folder / (sha256(stamp.file).substr(0, sum_size / 2) + std::string(ending));
}

class Writer {
public:
    void number(std::uint64_t value) {
        for (; value >= 0x80; value >>= 7) bytes_ += static_cast<char>(value | 0x80);
        bytes_ += static_cast<char>(value);
    }
    void text(std::string_view value) {
        number(value.size());
        bytes_ += value;
    }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

// Throws InputError where the bytes end too early.
class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}

    std::uint64_t number() {
        std::uint64_t value = 0;
        for (unsigned shift = 0; shift < 64; shift += 7) {
            const auto byte = static_cast<unsigned char>(take(1)[0]);
            value |= static_cast<std::uint64_t>(byte & 0x7fU) << shift;
            if (byte < 0x80) return value;
        }
        throw InputError("a number that is too long");
    }
    std::string text() { return std::string(take(number())); }
    // Of things that take a byte or more each.
    std::size_t count() {
        const std::uint64_t value = number();
        if (value > bytes_.size()) throw InputError("a count that is too large");
        return static_cast<std::size_t>(value);
    }

private:
    std::string_view take(std::uint64_t count) {
        if (count > bytes_.size()) throw InputError("the bytes end");
        const std::string_view taken = bytes_.substr(0, static_cast<std::size_t>(count));
        bytes_.remove_prefix(taken.size());
        return taken;
    }

    std::string_view bytes_;
};

void write(Writer& to, const FileStamp& stamp) {
    to.text(stamp.file);
    to.text(stamp.format);
    to.number(stamp.size);
    to.number(static_cast<std::uint64_t>(stamp.time));
    to.text(stamp.sum);
}

FileStamp read_stamp(Reader& from) {
    FileStamp stamp;
    stamp.file = from.text();
    stamp.format = from.text();
    stamp.size = from.number();
    stamp.time = static_cast<std::int64_t>(from.number());
    stamp.sum = from.text();
    return stamp;
}

// Frames follow each other, so that their lengths say where they are.
std::string packed(const FileStamp& stamp, const FrameIndex& index) {
    Writer to;
    write(to, stamp);
    to.number(index.frames.size());
    to.number(index.frames.front().begin);
    std::size_t line = 0;
    for (const FramePlace& place : index.frames) {
        to.number(place.end - place.begin);
        to.number(place.origin.line - line);
        to.number(place.origin.column);
        to.number(place.of_first);
        line = place.origin.line;
    }
    to.number(index.end_position.line);
    to.number(index.end_position.column);
    to.number(index.of_first);
    to.number(index.packed.spacing());
    to.number(index.packed.all().size());
    for (const GzipPlace& place : index.packed.all()) {
        to.number(place.packed);
        to.number(place.unpacked);
        to.number(place.bits);
        to.number(place.begins_member ? 1 : 0);
        to.text(place.text);
    }
    return to.bytes();
}

FrameIndex read_index(Reader& from) {
    FrameIndex index;
    index.frames.resize(from.count());
    std::uint64_t begin = from.number();
    std::size_t line = 0;
    for (FramePlace& place : index.frames) {
        place.begin = begin;
        place.end = begin += from.number();
        place.origin.line = line += static_cast<std::size_t>(from.number());
        place.origin.column = static_cast<std::size_t>(from.number());
        place.of_first = static_cast<std::size_t>(from.number());
    }
    index.end_position.line = static_cast<std::size_t>(from.number());
    index.end_position.column = static_cast<std::size_t>(from.number());
    index.of_first = static_cast<std::size_t>(from.number());
    index.packed = GzipPlaces(from.number());
    for (std::size_t left = from.count(); left > 0; --left) {
        GzipPlace place;
        place.packed = from.number();
        place.unpacked = from.number();
        place.bits = static_cast<unsigned>(from.number());
        place.begins_member = from.number() != 0;
        place.text = from.text();
        index.packed.add(std::move(place));
    }
    return index;
}

// Leaves room in the folder: who was used last stays.
void remove_oldest() {
    struct Kept {
        fs::path file;
        fs::file_time_type time;
        std::uint64_t size;
    };
    std::vector<Kept> all;
    std::error_code error;
    for (fs::directory_iterator entry(index_folder(), error), end; !error && entry != end; entry.increment(error)) {
        if (entry->path().extension() != ending) continue;
        std::error_code ignored;
        all.push_back({entry->path(), entry->last_write_time(ignored), entry->file_size(ignored)});
    }
    std::ranges::sort(all, std::ranges::greater(), &Kept::time);
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        bytes += all[i].size;
        if (i >= most_indexes || bytes > most_bytes) fs::remove(all[i].file, error);
    }
}

}  // namespace

std::optional<FileStamp> stamp_of(const std::string& path, std::string_view format) {
    try {
        FileStamp stamp;
        stamp.file = file_identity(path, FileUse::input);
        stamp.format = format;
        stamp.size = fs::file_size(path_from(path));
        stamp.time = static_cast<std::int64_t>(fs::last_write_time(path_from(path)).time_since_epoch().count());
        InputStream stream(path, Content::binary);
        if (!stream.is_regular() || !stream.size() || stamp.file.empty()) return std::nullopt;
        stream.fill(sampled_bytes);
        std::string sample(stream.bytes().substr(0, sampled_bytes));
        stream.go_to(stamp.size - std::min<std::uint64_t>(stamp.size, sampled_bytes));
        stream.fill(sampled_bytes);
        stamp.sum = sha256(sample += stream.bytes());
        return stamp;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

std::optional<FrameIndex> read_frame_index(const FileStamp& stamp) {
    try {
        const fs::path file = index_file(stamp);
        std::error_code error;
        if (file.empty() || !fs::is_regular_file(file, error) || fs::file_size(file) > longest_index) return std::nullopt;
        const InputFile kept(text_from(file), Content::binary);
        std::string_view bytes = kept.bytes();
        if (!bytes.starts_with(head) || bytes.size() < head.size() + sum_size) return std::nullopt;
        const std::string_view sum = bytes.substr(head.size(), sum_size);
        bytes.remove_prefix(head.size() + sum_size);
        if (sha256(bytes) != sum) return std::nullopt;
        Reader reader(bytes);
        if (read_stamp(reader) != stamp) return std::nullopt;
        FrameIndex index = read_index(reader);
        if (index.frames.empty()) return std::nullopt;
        fs::last_write_time(file, fs::file_time_type::clock::now(), error);
        return index;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

void keep_frame_index(const FileStamp& stamp, const FrameIndex& index) noexcept {
    try {
        const fs::path file = index_file(stamp);
        const auto age = fs::file_time_type::clock::now() - fs::last_write_time(path_from(stamp.file));
        if (file.empty() || index.frames.empty() || age < moment) return;
        const std::string bytes = packed(stamp, index);
        if (bytes.size() > longest_index - head.size() - sum_size || !make_user_folder(index_folder())) return;
        write_regular_file(text_from(file), std::string(head) + sha256(bytes) + bytes, Durability::in_system);
        remove_oldest();
    } catch (const std::exception&) {
        // The next run looks for the frames again.
    }
}

void forget_frame_index(const FileStamp& stamp) noexcept {
    try {
        std::error_code ignored;
        fs::remove(index_file(stamp), ignored);
    } catch (const std::exception&) {
        // It counts for nothing then.
    }
}

}  // namespace sphereview

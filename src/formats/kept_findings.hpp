// Keeps findings about large files between runs. Each finding is a file in the user's state folder (base/user_folders.hpp); their
// number and size are limited. They only save time: a finding that is damaged, or of a file that has changed, is ignored, and
// failures to write are, too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace sphereview {

// Tells whether a file has changed.
struct FileStamp {
    std::string file{};  // file_identity()
    std::string format{};
    std::uint64_t size = 0;
    std::int64_t time = 0;  // of the last change, in the file system's units
    std::string sum{};      // SHA-256 of some bytes at both ends

    bool operator==(const FileStamp&) const = default;
};

// Nothing if the file is not regular or not readable.
std::optional<FileStamp> stamp_of(const std::string& path, std::string_view format);

// A kind of findings, and its limits.
struct FindingKind {
    std::string_view ending{};     // of the files' names
    std::size_t longest = 0;       // bytes of a finding
    std::size_t most = 0;          // number of findings
    std::uint64_t most_bytes = 0;  // bytes of all findings
};

// The kept answer to a question about the file; nothing if there is no valid one.
std::optional<std::string> read_finding(const FindingKind& kind, const FileStamp& stamp, const std::string& question = "");

// Replaces the kept answer, whole or not at all, and removes the oldest findings beyond the limits. Keeps nothing if the answer is
// too long, or if the file was changed a moment ago, so that a further change would not show.
void keep_finding(const FindingKind& kind, const FileStamp& stamp, const std::string& question, std::string_view answer) noexcept;

void forget_finding(const FindingKind& kind, const FileStamp& stamp, const std::string& question = "") noexcept;

// Writes whole numbers, seven bits a byte, the low ones first, and texts with their lengths.
class KeptWriter {
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

// Throws InputError if the bytes end too early.
class KeptReader {
public:
    explicit KeptReader(std::string_view bytes) : bytes_(bytes) {}

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
    // A number of things that take a byte or more each.
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

}  // namespace sphereview

// Reading a whole input file.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace sphereview {

// The path that stands for standard input (as an input) and standard output (as an output).
inline constexpr std::string_view standard_stream = "-";

// What a file holds, which tells where a device or pipe without an end is left.
enum class Content { text, binary };

// A whole file in memory. It is read, not mapped: a mapped file that its editor truncates kills the reader (SIGBUS).
class InputFile {
public:
    // Reads `path`, or standard input for "-". Throws InputError when it is missing, a folder or unreadable.
    // A device or pipe is read up to its first zero byte, which no text holds (/dev/zero has no end), or up to 2 GiB.
    explicit InputFile(const std::string& path, Content content = Content::text);

    // How messages call it: the path as given, or "stdin".
    const std::string& name() const { return name_; }
    std::string_view bytes() const { return {data_.get(), size_}; }

    // Gives the memory of the first `count` bytes back to the system, where it can: from now on they read as anything.
    void release_first(std::size_t count);

private:
    std::string name_;
    std::unique_ptr<char[]> data_;  // not a vector: its bytes would be cleared before they are read
    std::size_t size_ = 0;
};

}  // namespace sphereview

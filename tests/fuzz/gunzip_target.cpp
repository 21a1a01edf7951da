#include <algorithm>

#include "base/error.hpp"
#include "base/gunzip.hpp"
#include "fuzz/targets.hpp"

namespace sphereview {

namespace {

// The text, or what is wrong with it, when it is read in pieces of so many bytes.
std::string unpacked(std::string_view bytes, std::size_t piece) {
    const auto source = [&](char* to, std::size_t most) {
        const std::size_t count = std::min({bytes.size(), most, piece});
        std::copy_n(bytes.data(), count, to);
        bytes.remove_prefix(count);
        return count;
    };
    Gunzip gunzip("bytes", "", source, {.small = 1 << 16, .ratio = 100, .most = 1 << 20});
    std::string text;
    std::string room(piece, '\0');
    try {
        while (const std::size_t count = gunzip.read(room.data(), piece)) text.append(room, 0, count);
    } catch (const InputError& error) {
        return error.what();
    }
    return "text: " + text;
}

bool is_text(const std::string& result) { return result.starts_with("text: "); }

bool is_beyond_bounds(const std::string& result) { return result.find("its text is longer than") != std::string::npos; }

}  // namespace

std::string fuzz_gunzip(std::string_view bytes) {
    const std::string at_once = unpacked(bytes, std::size_t{1} << 16);
    const std::string in_pieces = unpacked(bytes, 7);
    // Of two things that are wrong, zlib may meet another one first when it sees more at once.
    if (!is_text(at_once) && !is_text(in_pieces)) return "";
    // How much was read ahead decides when a bound is met.
    if (at_once == in_pieces || is_beyond_bounds(at_once) || is_beyond_bounds(in_pieces)) return "";
    return "at once: " + at_once + "\nin pieces: " + in_pieces;
}

}  // namespace sphereview

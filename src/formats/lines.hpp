// What the readers of all formats share: texts made of lines and words, read on all cores, and where in them a fault stands.
#pragma once

#include <cstddef>
#include <cstring>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "base/parallel.hpp"
#include "base/text.hpp"

namespace sphereview {

inline constexpr std::string_view white_space = " \t\n\v\f\r";

// A piece of a file: what messages call the file, and where in it the text begins.
struct TextSource {
    std::string name;
    std::string_view text;
    TextPosition origin{};

    // "NAME:LINE:COLUMN: " of byte `offset`.
    std::string place(std::size_t offset) const;
    // Of a piece of the text.
    std::string place(std::string_view piece) const { return place(static_cast<std::size_t>(piece.data() - text.data())); }
    // Throws InputError "NAME:LINE:COLUMN: MESSAGE".
    [[noreturn]] void fail(std::size_t offset, const std::string& message) const;
    // Throws InputError "NAME:LINE:COLUMN: found 'PIECE', expected EXPECTED".
    [[noreturn]] void fail(std::string_view piece, const std::string& expected) const;
};

// The pieces of a line between runs of separators.
std::vector<std::string_view> words_of(std::string_view line, std::string_view separators = white_space);

// The text behind a byte-order mark, white space and lines of comment that begin with '#'.
std::string_view behind_comments(std::string_view text);

// `bytes` with each that is no part of a UTF-8 sequence replaced by U+FFFD: names must be UTF-8.
std::string as_utf8(std::string_view bytes);

// How much of a text one core reads at a time.
inline constexpr std::size_t usual_line_piece = std::size_t{1} << 16;

// The character that ends the lines of a text: LF, also behind a CR, or CR where there is no LF.
inline char line_end_of(std::string_view text) {
    return text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos ? '\r' : '\n';
}

// Steps from line to line, as fast as memory.
class LineWalker {
public:
    // Begins at `offset`, where a line begins.
    LineWalker(std::string_view text, char line_end, std::size_t offset = 0) : text_(text), line_end_(line_end), offset_(offset) {}

    bool at_end() const { return offset_ >= text_.size(); }
    // Where the next line begins.
    std::size_t offset() const { return offset_; }

    // Steps over a line and returns where it ends, without what ends it. Not at_end().
    std::size_t step() {
        const std::size_t begin = offset_;
        const void* end = std::memchr(text_.data() + begin, line_end_, text_.size() - begin);
        std::size_t place = text_.size();
        if (end != nullptr) place = static_cast<std::size_t>(static_cast<const char*>(end) - text_.data());
        offset_ = place + (end == nullptr ? 0 : 1);
        return place > begin && text_[place - 1] == '\r' ? place - 1 : place;
    }

private:
    std::string_view text_;
    char line_end_;
    std::size_t offset_;
};

// Calls work(i) for each i below `count`, on all cores; of several exceptions that of the lowest i is thrown here.
template <typename Work>
void parallel_in_order(std::size_t count, const Work& work) {
    std::vector<std::exception_ptr> faults(count);
    parallel_for(count, [&](std::size_t i) {
        try {
            work(i);
        } catch (...) {
            faults[i] = std::current_exception();
        }
    });
    for (const std::exception_ptr& fault : faults) {
        if (fault) std::rethrow_exception(fault);
    }
}

}  // namespace sphereview

#include "formats/cif_fault.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>

#include "base/text.hpp"

namespace sphereview {

namespace {

// Where the word stands next at or behind `from`, in letters of either case, as CIF's names are; npos where it does not.
std::size_t find_word(std::string_view text, std::string_view word, std::size_t from) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    const auto same = [&](char a, char b) { return lower(a) == lower(b); };
    while (from < text.size()) {
        const std::string_view rest = text.substr(from);
        const auto found = std::search(rest.begin(), rest.end(), word.begin(), word.end(), same);
        if (found == rest.end()) break;
        const std::size_t begin = from + static_cast<std::size_t>(found - rest.begin());
        const std::size_t end = begin + word.size();
        if ((begin == 0 || is_space(text[begin - 1])) && (end == text.size() || is_space(text[end]))) return begin;
        from = begin + 1;
    }
    return std::string_view::npos;
}

// The word that begins a block, by gemmi's name of it: a nameless one is called #.
std::string head_of(std::string_view block) { return "data_" + std::string(block == "#" ? "" : block); }

// The text behind `beginning`; "" where it begins otherwise.
std::string_view behind(std::string_view text, std::string_view beginning) {
    return text.starts_with(beginning) ? text.substr(beginning.size()) : "";
}

// Where the line with this number begins.
std::size_t begin_of_line(std::string_view text, std::size_t line) {
    std::size_t begin = 0;
    for (; line > 1 && begin < text.size(); --line) begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
    return begin;
}

bool same_tag(std::string_view a, std::string_view b) { return a.size() == b.size() && find_word(a, b, 0) == 0; }

// A text's words from some place on; a quoted text and a text field are one each.
class CifWords {
public:
    CifWords(std::string_view text, std::size_t begin) : text_(text), at_(begin) {}

    // Empty at the end.
    std::string_view next() {
        skip_space();
        const std::size_t begin = at_;
        if (begin == text_.size()) return {};
        const char first = text_[begin];
        if (first == ';' && begins_line(begin)) {
            const std::size_t end = text_.find("\n;", begin);
            at_ = end == std::string_view::npos ? text_.size() : end + 2;
        } else if (first == '\'' || first == '"') {
            do {
                at_ = std::min(text_.find_first_of(std::string{first, '\n'}, at_ + 1), text_.size());
            } while (at_ + 1 < text_.size() && text_[at_] == first && !is_space(text_[at_ + 1]));
            if (at_ < text_.size() && text_[at_] == first) ++at_;
        } else {
            while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
        }
        return text_.substr(begin, at_ - begin);
    }

private:
    bool begins_line(std::size_t place) const { return place == 0 || text_[place - 1] == '\n'; }

    // And comments.
    void skip_space() {
        while (at_ < text_.size()) {
            if (text_[at_] == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else if (is_space(text_[at_])) {
                ++at_;
            } else {
                break;
            }
        }
    }

    std::string_view text_;
    std::size_t at_;
};

}  // namespace

std::size_t place_of_cif_word(std::string_view text, std::size_t line, std::span<const std::string> tags, std::size_t number) {
    CifWords words(text, begin_of_line(text, line));
    std::string_view word = words.next();
    // Others may stand before it in its line.
    while (!word.empty() && !same_tag(word, tags.front())) word = words.next();
    for (std::size_t i = 0; i < number && !word.empty(); ++i) {
        word = words.next();
        if (i + 1 < tags.size() && !same_tag(word, tags[i + 1])) return std::string_view::npos;
    }
    return word.empty() ? std::string_view::npos : static_cast<std::size_t>(word.data() - text.data());
}

std::string placed_cif_fault(const TextSource& source, const std::string& message) {
    const std::string_view text = source.text;
    const auto placed = [&](std::size_t place, std::string_view word, const char* rest) {
        return place == std::string_view::npos ? message : source.place(place) + "found " + in_quotes(word) + rest;
    };
    const std::string_view rest = behind(message, source.name + ":");
    if (const std::string_view block = behind(rest, " duplicate block name: "); !block.empty()) {
        const std::string head = head_of(block);
        const std::size_t first = find_word(text, head, 0);
        const std::size_t again = first == std::string_view::npos ? first : find_word(text, head, first + 1);
        return placed(again, head, " again, expected each name of a block once");
    }
    std::size_t line = 0;
    const auto number = std::from_chars(rest.data(), rest.data() + rest.size(), line);
    const std::string_view in_block =
        number.ec == std::errc{} ? behind(rest.substr(static_cast<std::size_t>(number.ptr - rest.data())), " in data_") : "";
    const std::size_t colon = in_block.find(": ");
    if (colon == std::string_view::npos) return message;
    const std::string_view fault = in_block.substr(colon + 2);
    const std::size_t begin = begin_of_line(text, line);
    if (behind(fault, "duplicate save_") != "") {
        const std::string_view frame = behind(fault, "duplicate ");
        return placed(find_word(text, frame, begin), frame, " again, expected each name of a save frame once");
    }
    if (const std::string_view tag = behind(fault, "duplicate tag "); !tag.empty()) {
        std::size_t place = find_word(text, tag, begin);
        // The line of a loop is that of its first word, which may stand before both.
        const std::size_t block = find_word(text, head_of(in_block.substr(0, colon)), 0);
        if (place != std::string_view::npos && block < place && find_word(text, tag, block) == place) {
            place = find_word(text, tag, place + 1);
        }
        return placed(place, tag, " again, expected each tag of a block once");
    }
    constexpr std::string_view no_value = " has no value";
    if (!fault.ends_with(no_value)) return message;
    const std::string_view tag = fault.substr(0, fault.size() - no_value.size());
    return placed(find_word(text, tag, begin), tag, " without a value, expected one behind it");
}

}  // namespace sphereview

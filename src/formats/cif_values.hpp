// Shared by the readers of CIF: values, and their places in the text. For sources that may include gemmi.
#pragma once

#include <cmath>
#include <cstddef>
#include <gemmi/cifdoc.hpp>
#include <gemmi/numb.hpp>
#include <span>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/text.hpp"
#include "formats/cif_fault.hpp"
#include "formats/csv_values.hpp"
#include "formats/lines.hpp"

namespace sphereview {

// gemmi keeps only the line of a table or a pair; this searches for the word from there on.
inline std::string at_word(const TextSource& source, const gemmi::cif::Item& item, std::size_t number, const std::string& message) {
    const bool is_loop = item.type == gemmi::cif::ItemType::Loop;
    const std::span<const std::string> tags = is_loop ? std::span(item.loop.tags) : std::span(item.pair.data(), 1);
    const std::size_t place = place_of_cif_word(source.text, static_cast<std::size_t>(item.line_number), tags, number);
    const std::string line = source.name + ":" + std::to_string(item.line_number) + ": ";
    return (place == std::string_view::npos ? line : source.place(place)) + message;
}

// `tag`: the number of the table's tag.
[[noreturn]] inline void fail_at_tag(const TextSource& source, const gemmi::cif::Item& item, const std::string& message,
                                     std::size_t tag = 0) {
    throw InputError(at_word(source, item, tag, message));
}

// `value`: the number of the table's value, row by row.
inline std::string at_value(const TextSource& source, const gemmi::cif::Item& item, const std::string& message,
                            std::size_t value = 0) {
    const std::size_t tags = item.type == gemmi::cif::ItemType::Loop ? item.loop.tags.size() : 1;
    return at_word(source, item, tags + value, message);
}

[[noreturn]] inline void fail_at_value(const TextSource& source, const gemmi::cif::Item& item, const std::string& message,
                                       std::size_t value = 0) {
    throw InputError(at_value(source, item, message, value));
}

// The table must have the column.
[[noreturn]] inline void fail_at_value(const TextSource& source, const gemmi::cif::Table::Row& row, std::size_t column,
                                       const std::string& message) {
    const auto place = static_cast<std::size_t>(row.tab.positions.at(column));
    const gemmi::cif::Item* loop = row.tab.loop_item;
    if (loop == nullptr) fail_at_value(source, row.tab.bloc.items[place], message);
    fail_at_value(source, *loop, message, static_cast<std::size_t>(row.row_index) * loop->loop.width() + place);
}

inline const gemmi::cif::Item& first_item(gemmi::cif::Table& table) {
    return table.loop_item != nullptr ? *table.loop_item : table.bloc.items[static_cast<std::size_t>(table.positions[0])];
}

// The text of a value without its quotes.
inline std::string_view without_quotes(std::string_view value) {
    const bool quoted = value.size() > 1 && (value.front() == '"' || value.front() == '\'') && value.back() == value.front();
    return quoted ? value.substr(1, value.size() - 2) : value;
}

// The number of a value, perhaps in quotes; not finite if it is none.
inline double number_in(const std::string& value) {
    const double number = gemmi::cif::as_number(value);
    return std::isfinite(number) ? number : gemmi::cif::as_number(gemmi::cif::as_string(value));
}

// Whether the value means a missing number: ? or a point, or programs' words for that (csv_values.hpp).
inline bool is_without_number(const std::string& value) { return gemmi::cif::is_null(value) || is_missing(without_quotes(value)); }

// The text of a value; "" if the table lacks it, or for ? and a point.
inline std::string_view text_of(const gemmi::cif::Table::Row& row, std::size_t column) {
    return row.has2(column) ? without_quotes(row[column]) : "";
}

}  // namespace sphereview

// What the readers of CIF share: values, and where in the text they stand. For sources that may include gemmi.
#pragma once

#include <gemmi/cifdoc.hpp>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/text.hpp"
#include "formats/lines.hpp"

namespace sphereview {

// gemmi keeps only the line of a table, or of a pair of a tag and a value.
inline std::string in_line(const TextSource& source, const gemmi::cif::Item& item, const std::string& message) {
    return source.name + ":" + std::to_string(item.line_number) + ": " + message;
}

[[noreturn]] inline void fail_in_line(const TextSource& source, const gemmi::cif::Item& item, const std::string& message) {
    throw InputError(in_line(source, item, message));
}

inline const gemmi::cif::Item& first_item(gemmi::cif::Table& table) {
    return table.loop_item != nullptr ? *table.loop_item : table.bloc.items[static_cast<std::size_t>(table.positions[0])];
}

// The text of a value without its quotes.
inline std::string_view without_quotes(std::string_view value) {
    const bool quoted = value.size() > 1 && (value.front() == '"' || value.front() == '\'') && value.back() == value.front();
    return quoted ? value.substr(1, value.size() - 2) : value;
}

// The text of a value of a table that may lack it; "" where it does, or says ? or a point.
inline std::string_view text_of(const gemmi::cif::Table::Row& row, std::size_t column) {
    return row.has2(column) ? without_quotes(row[column]) : "";
}

}  // namespace sphereview

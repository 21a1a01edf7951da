// mmCIF (PDBx), read by gemmi into its document. The document keeps the lines of tables, but not those of values. gemmi's Structure
// is not made of the document: it has no atom at all where one of seven more columns is missing, and holds every model at once.
#include <cmath>
#include <gemmi/cif.hpp>
#include <gemmi/numb.hpp>
#include <unordered_map>
#include <vector>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/text.hpp"
#include "formats/atom_names.hpp"
#include "formats/lines.hpp"
#include "formats/macromolecule.hpp"

namespace sphereview {

namespace {

namespace cif = gemmi::cif;

constexpr const char* atom_table = "_atom_site.";
constexpr const char* table_syntax = "the table _atom_site with Cartn_x, Cartn_y and Cartn_z";

// The columns of mmCIF's table of atoms; those that it may lack have gemmi's question mark.
enum Column : std::size_t {
    x,
    y,
    z,
    type_symbol,
    auth_atom,
    label_atom,
    auth_residue,
    label_residue,
    auth_chain,
    label_chain,
    auth_number,
    label_number,
    insertion_code,
    alternative,
    occupancy,
    model
};
constexpr std::string_view atom_columns =
    "Cartn_x Cartn_y Cartn_z ?type_symbol ?auth_atom_id ?label_atom_id ?auth_comp_id ?label_comp_id ?auth_asym_id ?label_asym_id "
    "?auth_seq_id ?label_seq_id ?pdbx_PDB_ins_code ?label_alt_id ?occupancy ?pdbx_PDB_model_num";

cif::Document read_document(const TextSource& source) {
    try {
        return cif::read_memory(source.text.data(), source.text.size(), source.name.c_str());
    } catch (const std::runtime_error& error) {  // gemmi's message begins with the name and the line
        throw InputError(error.what());
    }
}

// gemmi keeps only the line of a table, or of a pair of a tag and a value.
std::string in_line(const TextSource& source, const cif::Item& item, const std::string& message) {
    return source.name + ":" + std::to_string(item.line_number) + ": " + message;
}

[[noreturn]] void fail_in_line(const TextSource& source, const cif::Item& item, const std::string& message) {
    throw InputError(in_line(source, item, message));
}

const cif::Item& first_item(cif::Table& table) {
    return table.loop_item != nullptr ? *table.loop_item : table.bloc.items[static_cast<std::size_t>(table.positions[0])];
}

// The block's table of atoms, not ok() where it has none.
cif::Table atoms_of(const TextSource& source, cif::Block& block) {
    // gemmi throws its own error for columns of another table in this one.
    for (const cif::Item& item : block.items) {
        if (!item.has_prefix(atom_table) || item.type != cif::ItemType::Loop) continue;
        for (const std::string& tag : item.loop.tags) {
            if (!gemmi::istarts_with(tag, atom_table)) fail_in_line(source, item, found_expected(tag, "a column of _atom_site"));
        }
    }
    return block.find_mmcif_category(atom_table);
}

// The tables of atoms, of which each block may have one.
struct AtomTables {
    std::vector<cif::Table> tables{};
    std::string fault{};  // of another one, which is passed over; "" where there is none
};

AtomTables find_atoms(const TextSource& source, cif::Document& document) {
    const auto words = words_of(atom_columns);
    const std::vector<std::string> columns(words.begin(), words.end());
    AtomTables found;
    for (cif::Block& block : document.blocks) {
        const cif::Item* crystal = block.find_loop_item("_atom_site_fract_x");
        cif::Table any = atoms_of(source, block);
        if (any.ok()) {
            const cif::Table table = block.find(atom_table, columns);
            if (table.ok() && table.length() > 0) found.tables.push_back(table);
            if (table.ok() || !found.fault.empty()) continue;
            found.fault = in_line(source, first_item(any),
                                  "found a table of atoms without one of their places, expected Cartn_x, Cartn_y and Cartn_z");
        } else if (crystal != nullptr && found.fault.empty()) {
            found.fault =
                in_line(source, *crystal, "found a crystal in fractional coordinates, expected mmCIF with _atom_site.Cartn_x");
        }
    }
    if (!found.tables.empty()) return found;
    if (!found.fault.empty()) throw InputError(found.fault);
    fail_without_atoms(source, table_syntax);
}

// The text of a value without its quotes; "" where there is none.
std::string_view text_of(const cif::Table::Row& row, Column column) {
    if (!row.has2(column)) return "";
    const std::string_view value = row[column];
    const bool quoted = value.size() > 1 && (value.front() == '"' || value.front() == '\'') && value.back() == value.front();
    return quoted ? value.substr(1, value.size() - 2) : value;
}

std::string_view first_of(const cif::Table::Row& row, Column column, Column other) {
    const std::string_view text = text_of(row, column);
    return text.empty() ? text_of(row, other) : text;
}

double coordinate(const TextSource& source, const cif::Table::Row& row, Column column) {
    const std::string& value = row[column];
    double number = cif::as_number(value);
    if (!std::isfinite(number)) number = cif::as_number(cif::as_string(value));
    if (std::isfinite(number)) return number;
    fail_in_line(source, first_item(row.tab),
                 found_expected(value, std::string(1, "xyz"[column]) + " of atom " + std::to_string(row.row_index + 1) +
                                           " of the table, a number"));
}

// What gemmi's document of a text takes at most: a string for each word, in an array that grows, or an item or block of its own for
// a few; and the longer words' letters. Measured: 54 bytes a word of one digit, 73 for each `data_`.
std::uint64_t bytes_of_document(std::string_view text) {
    constexpr std::uint64_t bytes_of_word = 64;
    const auto ends_word = [&](std::size_t i) {
        const bool space = is_space(text[i]);
        const bool space_before = is_space(text[i - 1]);
        return space & !space_before;
    };
    const std::uint64_t words = text.empty() ? 0 : 1 + count_places(1, text.size(), ends_word);
    return words * bytes_of_word + 2 * std::uint64_t{text.size()};
}

const Element& element_of(std::string_view symbol, std::string_view atom, std::string_view residue) {
    if (symbol.empty() || residue == "DUM") return element_of_name(atom, residue, NameColumns::unknown);
    const Element& element = element_of_species(symbol);
    return is_virtual(element) ? dummy_in(residue) : element;
}

MoleculeAtom atom_of(const TextSource& source, const cif::Table::Row& row) {
    MoleculeAtom atom;
    atom.position = {coordinate(source, row, x), coordinate(source, row, y), coordinate(source, row, z)};
    atom.atom = first_of(row, auth_atom, label_atom);
    atom.chain = first_of(row, auth_chain, label_chain);
    atom.residue = first_of(row, auth_residue, label_residue);
    atom.element = &element_of(text_of(row, type_symbol), atom.atom, atom.residue);
    atom.residue_number = std::string(first_of(row, auth_number, label_number)).append(text_of(row, insertion_code));
    atom.alternative = text_of(row, alternative);
    if (row.has2(occupancy)) atom.occupancy = cif::as_number(row[occupancy], 1.0);
    if (!std::isfinite(atom.occupancy)) atom.occupancy = 1.0;
    return atom;
}

// The table and the model in it that are the wanted frame: the models of each block follow on those of the block before.
struct WantedModel {
    std::int64_t frames = 0;  // of all tables
    std::size_t table = 0;
    std::string_view model{};
    std::size_t atoms = 0;
};

WantedModel find_model(std::vector<cif::Table>& tables, std::int64_t wanted) {
    WantedModel found;
    for (std::size_t i = 0; i < tables.size(); ++i) {
        std::unordered_map<std::string_view, std::int64_t> models;
        for (const auto row : tables[i]) {
            const std::string_view model = text_of(row, Column::model);
            const std::int64_t frame = models.emplace(model, found.frames + static_cast<std::int64_t>(models.size())).first->second;
            if (frame != wanted) continue;
            found.table = i;
            found.model = model;
            ++found.atoms;
        }
        found.frames += static_cast<std::int64_t>(models.size());
    }
    return found;
}

}  // namespace

SphereData read_mmcif(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, without_byte_order_mark(content)};
    if (trimmed(source.text, white_space).empty()) fail_without_atoms(source, table_syntax);
    require_memory(bytes_of_document(source.text), name + ": its values need");
    cif::Document document = read_document(source);
    AtomTables found = find_atoms(source, document);
    const WantedModel wanted = find_model(found.tables, options.frame);
    require_frame(name, options.frame, wanted.frames);
    require_memory(wanted.atoms * sizeof(Sphere), name + ": " + in_groups(wanted.atoms) + " spheres need");
    MoleculeScene scene(wanted.atoms, options);
    for (const auto row : found.tables[wanted.table]) {
        if (text_of(row, model) == wanted.model) scene.add(atom_of(source, row));
    }
    SphereData data = scene.take(name);
    data.frames = wanted.frames;
    if (!found.fault.empty()) data.warnings.push_back(found.fault + "; passed over");
    return data;
}

}  // namespace sphereview

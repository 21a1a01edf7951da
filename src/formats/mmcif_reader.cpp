// mmCIF (PDBx), read by gemmi into its document. The document keeps the lines of tables, but not those of values. gemmi's Structure
// is not made of the document: it has no atom at all where one of seven more columns is missing, and holds every model at once.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <gemmi/cif.hpp>
#include <unordered_map>
#include <vector>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/text.hpp"
#include "formats/atom_names.hpp"
#include "formats/atoms.hpp"
#include "formats/cif_fault.hpp"
#include "formats/cif_values.hpp"
#include "formats/crystal.hpp"
#include "formats/lines.hpp"
#include "formats/macromolecule.hpp"

namespace sphereview {

namespace {

namespace cif = gemmi::cif;

constexpr const char* atom_table = "_atom_site.";
constexpr const char* table_syntax =
    "the table _atom_site with Cartn_x, Cartn_y and Cartn_z, or a crystal's with fract_x, fract_y and fract_z";

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
    model,
    b_factor,
    charge,
    calc_flag
};
constexpr std::string_view atom_columns =
    "Cartn_x Cartn_y Cartn_z ?type_symbol ?auth_atom_id ?label_atom_id ?auth_comp_id ?label_comp_id ?auth_asym_id ?label_asym_id "
    "?auth_seq_id ?label_seq_id ?pdbx_PDB_ins_code ?label_alt_id ?occupancy ?pdbx_PDB_model_num "
    "?B_iso_or_equiv ?pdbx_formal_charge ?calc_flag";

// The same columns of a core CIF whose places are no parts of a cell; what the table never has is -.
constexpr const char* core_table = "_atom_site_";
constexpr std::string_view core_columns =
    "Cartn_x Cartn_y Cartn_z ?type_symbol ?label ?- ?- ?- ?- ?- ?- ?- ?- ?- ?occupancy ?- ?B_iso_or_equiv ?- ?calc_flag";

struct ReadDocument {
    cif::Document document{};
    std::string fault{};  // of the text's last line, which is left out; "" where nothing is wrong
};

// A program that was ended while it wrote leaves half a line.
ReadDocument read_document(const TextSource& source) {
    const auto read = [&](std::size_t length) { return cif::read_memory(source.text.data(), length, source.name.c_str()); };
    std::string fault;
    try {
        return {read(source.text.size())};
    } catch (const std::runtime_error& error) {
        fault = placed_cif_fault(source, error.what());
    }
    const std::size_t last_line = source.text.find_last_of("\r\n") + 1;  // 0 where the text has no other
    try {
        if (last_line < source.text.size()) {
            ReadDocument without{read(last_line), fault};
            if (!without.document.blocks.empty()) return without;
        }
    } catch (const std::runtime_error&) {
        // More is wrong than the last line.
    }
    throw InputError(fault);
}

// The block's table of atoms, not ok() where it has none.
cif::Table atoms_of(const TextSource& source, cif::Block& block) {
    // gemmi throws its own error for columns of another table in this one.
    for (const cif::Item& item : block.items) {
        if (!item.has_prefix(atom_table) || item.type != cif::ItemType::Loop) continue;
        for (std::size_t i = 0; i < item.loop.tags.size(); ++i) {
            const std::string& tag = item.loop.tags[i];
            if (!gemmi::istarts_with(tag, atom_table)) fail_at_tag(source, item, found_expected(tag, "a column of _atom_site"), i);
        }
    }
    return block.find_mmcif_category(atom_table);
}

// The columns of chemical components in the order of the others; what the table never has is -. A component is a model of its own.
constexpr const char* component_table = "_chem_comp_atom.";
constexpr std::string_view component_columns = " ?type_symbol ?atom_id ?- ?comp_id ?- ?- ?- ?- ?- ?- ?- ?- ?comp_id ?- ?charge ?-";
constexpr auto component_places =
    std::to_array<std::string_view>({"model_Cartn_x model_Cartn_y model_Cartn_z",
                                     "pdbx_model_Cartn_x_ideal pdbx_model_Cartn_y_ideal pdbx_model_Cartn_z_ideal", "x y z"});

// A table of atoms, and whether they are a crystal's.
struct AtomTable {
    cif::Table table;
    bool is_crystal = false;
};

// The tables of atoms, of which each block may have one.
struct AtomTables {
    std::vector<AtomTable> tables{};
    std::string fault{};  // of another one, which is passed over; "" where there is none
};

std::vector<std::string> column_names(std::string_view words) {
    const auto names = words_of(words);
    return {names.begin(), names.end()};
}

// Of the kinds of places that a component has the first of which all are known; not ok() where none is.
cif::Table component_atoms(cif::Block& block) {
    for (const std::string_view places : component_places) {
        cif::Table table = block.find(component_table, column_names(std::string(places).append(component_columns)));
        if (!table.ok()) continue;
        bool is_whole = true;
        for (const auto row : table) is_whole = is_whole && row.has2(x) && row.has2(y) && row.has2(z);
        if (is_whole) return table;
    }
    return block.find(component_table, {"-"});
}

AtomTables find_atoms(const TextSource& source, cif::Document& document) {
    const std::vector<std::string> columns = column_names(atom_columns);
    AtomTables found;
    for (cif::Block& block : document.blocks) {
        cif::Table any = atoms_of(source, block);
        const cif::Table table = block.find(atom_table, columns);
        if (any.ok() && table.ok()) {
            if (table.length() > 0) found.tables.push_back({table});
            continue;
        }
        const cif::Table crystal = crystal_atoms(block);
        const cif::Table core = block.find(core_table, column_names(core_columns));
        const cif::Table component = component_atoms(block);
        if (crystal.ok() && crystal.length() > 0) {
            found.tables.push_back({crystal, true});
        } else if (core.ok() && core.length() > 0) {
            found.tables.push_back({core});
        } else if (component.ok() && component.length() > 0) {
            found.tables.push_back({component});
        } else if (any.ok() && found.fault.empty()) {
            found.fault = at_word(source, first_item(any), 0,
                                  "found a table of atoms without one of their places, expected Cartn_x, Cartn_y and Cartn_z");
        }
    }
    if (!found.tables.empty()) return found;
    if (!found.fault.empty()) throw InputError(found.fault);
    fail_without_atoms(source, table_syntax);
}

std::string_view first_of(const cif::Table::Row& row, Column column, Column other) {
    const std::string_view text = text_of(row, column);
    return text.empty() ? text_of(row, other) : text;
}

// Not finite where the value says that there is none.
double coordinate(const TextSource& source, const cif::Table::Row& row, Column column) {
    const std::string& value = row[column];
    const double number = number_in(value);
    if (std::isfinite(number) || is_without_number(value)) return number;
    fail_at_value(source, row, column,
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

// gemmi looks for names that are there twice in time with the product of the blocks and the most names, of blocks or of one block's
// values, that it holds together. A dictionary of components has 50,000 blocks.
void require_bounded_work(const TextSource& source) {
    constexpr std::uint64_t most_work = 10'000'000'000;  // some seconds
    const std::string_view text = source.text;
    const auto begins_word = [&](std::size_t i) { return i == 0 || is_space(text[i - 1]); };
    std::uint64_t blocks = 0;
    std::uint64_t names = 0;  // of the current block
    std::uint64_t most_names = 0;
    for (std::size_t i = text.find('_'); i != std::string_view::npos; i = text.find('_', i + 1)) {
        const bool begins_block = i >= 4 && begins_word(i - 4) && lower_case(text.substr(i - 4, 4)) == "data";
        if (begins_block) {
            ++blocks;
            names = 0;
        } else if (begins_word(i)) {
            ++names;
        }
        most_names = std::max({most_names, blocks, names});
        if (blocks * most_names > most_work) {
            source.fail(begins_block ? i - 4 : i, "found " + in_groups(blocks) + " blocks, expected at most " +
                                                      in_groups(most_work / most_names) + " where up to " + in_groups(most_names) +
                                                      " names are together");
        }
    }
}

const Element& element_of(const cif::Table::Row& row, std::string_view atom, std::string_view residue) {
    if (lower_case(text_of(row, calc_flag)) == "dum") return virtual_site();
    const std::string_view symbol = text_of(row, type_symbol);
    if (symbol.empty() && residue.empty()) return element_of_site(atom);
    if (symbol.empty() || residue == "DUM") return element_of_name(atom, residue, NameColumns::unknown);
    const Element& element = element_of_species(symbol);
    return is_virtual(element) ? dummy_in(residue) : element;
}

MoleculeAtom atom_of(const TextSource& source, const cif::Table::Row& row, bool wants_texts) {
    MoleculeAtom atom;
    atom.position = {coordinate(source, row, x), coordinate(source, row, y), coordinate(source, row, z)};
    atom.atom = first_of(row, auth_atom, label_atom);
    atom.chain = first_of(row, auth_chain, label_chain);
    atom.residue = first_of(row, auth_residue, label_residue);
    atom.element = &element_of(row, atom.atom, atom.residue);
    atom.residue_number = std::string(first_of(row, auth_number, label_number)).append(text_of(row, insertion_code));
    atom.alternative = text_of(row, alternative);
    if (row.has2(occupancy)) atom.occupancy = cif::as_number(row[occupancy], 1.0);
    if (!std::isfinite(atom.occupancy)) atom.occupancy = 1.0;
    if (wants_texts) {
        atom.texts = {.b_factor = text_of(row, b_factor), .occupancy = text_of(row, occupancy), .charge = text_of(row, charge)};
    }
    return atom;
}

// The table and the model in it that are the wanted frame: the models of each block follow on those of the block before.
struct WantedModel {
    std::int64_t frames = 0;  // of all tables
    std::size_t table = 0;
    std::string_view model{};
    std::size_t atoms = 0;
};

WantedModel find_model(std::vector<AtomTable>& tables, std::int64_t wanted) {
    WantedModel found;
    for (std::size_t i = 0; i < tables.size(); ++i) {
        if (tables[i].is_crystal) {
            if (found.frames++ == wanted) found.table = i;
            continue;
        }
        std::unordered_map<std::string_view, std::int64_t> models;
        for (const auto row : tables[i].table) {
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

SphereData read_model(const TextSource& source, cif::Table& table, const WantedModel& wanted, const DataOptions& options) {
    MoleculeScene scene(wanted.atoms, options, source.name);
    std::size_t nowhere = 0;
    for (const auto row : table) {
        if (text_of(row, model) != wanted.model) continue;
        const MoleculeAtom atom = atom_of(source, row, scene.wants_texts());
        const glm::dvec3& place = atom.position;
        if (std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z)) {
            scene.add(atom);
        } else {
            ++nowhere;
        }
    }
    if (nowhere == wanted.atoms) {
        fail_at_tag(source, first_item(table), "found atoms without places, expected Cartn_x, Cartn_y and Cartn_z as numbers");
    }
    SphereData data = scene.take();
    warn_of_left_out(data, nowhere, source.name, "atom", "atoms");
    return data;
}

}  // namespace

SphereData read_mmcif(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, text_of_file(content)};
    if (trimmed(source.text, white_space).empty()) fail_without_atoms(source, table_syntax);
    require_bounded_work(source);
    require_memory(bytes_of_document(source.text), name + ": its values need");
    ReadDocument read = read_document(source);
    AtomTables found = find_atoms(source, read.document);
    WantedModel wanted = find_model(found.tables, options.frame);
    if (!read.fault.empty()) {
        --wanted.frames;  // the last one is not whole
        if (options.frame >= wanted.frames) throw InputError(read.fault);
    }
    require_frame(name, options.frame, wanted.frames);
    AtomTable& table = found.tables[wanted.table];
    SphereData data =
        table.is_crystal ? read_crystal(source, table.table, options) : read_model(source, table.table, wanted, options);
    data.frames = wanted.frames;
    if (!found.fault.empty()) data.warnings.push_back(found.fault + "; passed over");
    data.fault = read.fault;
    // Who reads one frame after the other knows it from the first reading.
    if (!data.fault.empty() && !options.part.stops) data.warnings.push_back(early_end(data.fault, wanted.frames));
    return data;
}

}  // namespace sphereview

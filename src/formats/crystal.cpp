#include "formats/crystal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gemmi/symmetry.hpp>
#include <map>
#include <optional>
#include <utility>

#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/parallel.hpp"
#include "base/square_root.hpp"
#include "formats/atom_lines.hpp"
#include "formats/atom_names.hpp"
#include "formats/atoms.hpp"
#include "formats/cell.hpp"
#include "formats/cif_values.hpp"

namespace sphereview {

namespace {

namespace cif = gemmi::cif;

enum class SiteColumn : std::size_t { x, y, z, label, type_symbol, assembly, group, occupancy, u_iso };
constexpr std::string_view site_columns =
    "fract_x fract_y fract_z ?label ?type_symbol ?disorder_assembly ?disorder_group ?occupancy "
    "?U_iso_or_equiv";

// Images of one atom that are nearer to each other are the same: the atom lies on an element of symmetry, and its numbers are
// rounded. In angstrom, as gemmi has it.
constexpr double same_place = 0.4;

// Twice as many as any space group has.
constexpr std::size_t most_operations = 384;

const cif::Item* pair_of(const cif::Block& block, std::initializer_list<const char*> tags) {
    for (const char* tag : tags) {
        if (const cif::Item* item = block.find_pair_item(tag)) return item;
    }
    return nullptr;
}

// Nothing where the block has none of the tags, or says ? or a point.
std::optional<double> number_of(const TextSource& source, const cif::Block& block, std::initializer_list<const char*> tags) {
    const cif::Item* item = pair_of(block, tags);
    if (item == nullptr || cif::is_null(item->pair[1])) return std::nullopt;
    const double number = cif::as_number(cif::as_string(item->pair[1]));
    if (!std::isfinite(number)) fail_at_value(source, *item, found_expected(item->pair[1], item->pair[0] + ", a number"));
    return number;
}

Cell cell_in(const TextSource& source, const cif::Block& block, const cif::Item& atoms) {
    const auto length = [&](std::initializer_list<const char*> tags) {
        const std::optional<double> number = number_of(source, block, tags);
        if (!number) {
            fail_at_tag(source, atoms,
                        "found places in parts of a cell, expected its lengths too, as " + std::string(*tags.begin()));
        }
        const cif::Item& item = *pair_of(block, tags);
        if (!(*number > 0.0)) fail_at_value(source, item, found_expected(item.pair[1], item.pair[0] + " above 0"));
        return *number;
    };
    constexpr double right = 90.0;
    const glm::dvec3 lengths = {length({"_cell_length_a", "_cell.length_a"}), length({"_cell_length_b", "_cell.length_b"}),
                                length({"_cell_length_c", "_cell.length_c"})};
    const double alpha = number_of(source, block, {"_cell_angle_alpha", "_cell.angle_alpha"}).value_or(right);
    const double beta = number_of(source, block, {"_cell_angle_beta", "_cell.angle_beta"}).value_or(right);
    const double gamma = number_of(source, block, {"_cell_angle_gamma", "_cell.angle_gamma"}).value_or(right);
    const std::optional<Cell> cell = cell_of(lengths, alpha, beta, gamma);
    if (cell) return *cell;
    fail_at_tag(source, *pair_of(block, {"_cell_length_a", "_cell.length_a"}),
                "found angles " + shortest(alpha) + ", " + shortest(beta) + " and " + shortest(gamma) +
                    ", expected angles that a cell can have");
}

// One operation: where an atom comes again, in parts of the edges.
struct SymmetryOperation {
    std::array<std::array<double, 3>, 3> turn{};  // of -1, 0 and 1
    std::array<double, 3> shift{};

    explicit SymmetryOperation(const gemmi::Op& op) {
        constexpr double unit = gemmi::Op::DEN;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) turn[i][k] = op.rot[i][k] / unit;
            shift[i] = op.tran[i] / unit;
        }
    }

    // Within the cell: each part from 0 to below 1.
    glm::dvec3 image_of(const glm::dvec3& place) const {
        glm::dvec3 image;
        for (std::size_t i = 0; i < 3; ++i) {
            const double part = ((turn[i][0] * place.x + turn[i][1] * place.y) + turn[i][2] * place.z) + shift[i];
            const double inside = part - std::floor(part);
            image[static_cast<int>(i)] = inside < 1.0 ? inside : 0.0;
        }
        return image;
    }
};

// "x,y,z" of long numbers would be beyond what gemmi's numbers hold.
std::optional<gemmi::Op> operation_in(const std::string& triplet) {
    constexpr std::size_t longest = 64;
    constexpr std::size_t most_digits = 3;
    std::size_t digits = 0;
    for (const char c : triplet) {
        digits = c >= '0' && c <= '9' ? digits + 1 : 0;
        if (digits > most_digits) return std::nullopt;
    }
    if (triplet.size() > longest) return std::nullopt;
    try {
        return gemmi::parse_triplet(triplet);
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

// As the block lists them, or as its space group has them. None where the block says nothing of symmetry.
std::vector<SymmetryOperation> operations_in(const TextSource& source, cif::Block& block, std::vector<std::string>& warnings) {
    std::vector<SymmetryOperation> operations;
    for (const char* tag : {"_space_group_symop_operation_xyz", "_space_group_symop.operation_xyz", "_symmetry_equiv_pos_as_xyz",
                            "_symmetry_equiv.pos_as_xyz"}) {
        cif::Column column = block.find_values(tag);
        if (column.item() == nullptr) continue;
        const cif::Item& item = *column.item();
        const bool is_loop = item.type == cif::ItemType::Loop;
        const std::size_t width = is_loop ? item.loop.width() : 1;
        std::size_t place = is_loop ? static_cast<std::size_t>(item.loop.find_tag(tag)) : 0;  // among the item's values
        for (const std::string& value : column) {
            if (!cif::is_null(value)) {
                const std::optional<gemmi::Op> op = operation_in(cif::as_string(value));
                if (!op) fail_at_value(source, item, found_expected(value, "an operation of symmetry, as -x,y+1/2,z"), place);
                if (operations.size() == most_operations) {
                    fail_at_value(source, item,
                                  "found more operations of symmetry, expected at most " + std::to_string(most_operations), place);
                }
                operations.emplace_back(*op);
            }
            place += width;
        }
        if (!operations.empty()) return operations;
    }
    const cif::Item* named =
        pair_of(block, {"_space_group_name_H-M_alt", "_space_group.name_H-M_alt", "_symmetry_space_group_name_H-M",
                        "_symmetry.space_group_name_H-M", "_space_group_IT_number", "_space_group.IT_number",
                        "_symmetry_Int_Tables_number", "_symmetry.Int_Tables_number"});
    if (named == nullptr || cif::is_null(named->pair[1])) return operations;
    constexpr std::size_t longest_name = 32;
    const std::string name = cif::as_string(named->pair[1]);
    const gemmi::SpaceGroup* group = name.size() <= longest_name ? gemmi::find_spacegroup_by_name(name) : nullptr;
    if (group == nullptr) {
        warnings.push_back(at_value(source, *named,
                                    found_expected(name, "a space group that is known; only the atoms that are listed are shown")));
        return operations;
    }
    for (const gemmi::Op& op : group->operations()) operations.emplace_back(op);
    return operations;
}

std::string_view site_text(const cif::Table::Row& row, SiteColumn column) { return text_of(row, static_cast<std::size_t>(column)); }

// How much of the atom is there.
double fullness(const cif::Table::Row& row) {
    constexpr auto column = static_cast<std::size_t>(SiteColumn::occupancy);
    return row.has2(column) ? cif::as_number(row[column], 1.0) : 1.0;
}

// The fullest alternative of each assembly of disordered atoms.
using KeptAlternatives = std::map<std::string_view, std::pair<std::string_view, double>>;

bool is_alternative(std::string_view group) { return !group.empty() && group != "0"; }

KeptAlternatives kept_alternatives(cif::Table& atoms) {
    KeptAlternatives kept;
    for (const auto row : atoms) {
        const std::string_view of = site_text(row, SiteColumn::group);
        if (!is_alternative(of)) continue;
        const double full = fullness(row);
        const auto [best, is_new] = kept.try_emplace(site_text(row, SiteColumn::assembly), of, full);
        if (!is_new && full > best->second.second) best->second = {of, full};
    }
    return kept;
}

double way_length(const Cell& cell, const glm::dvec3& parts) {
    const glm::dvec3 way = cell.place(parts);
    return square_root((way.x * way.x + way.y * way.y) + way.z * way.z);
}

// Where an atom is: as it is written, and its images elsewhere.
void find_places(const Cell& cell, const std::vector<SymmetryOperation>& operations, const glm::dvec3& place,
                 std::vector<glm::dvec3>& places) {
    places.assign(1, place);
    for (const SymmetryOperation& operation : operations) {
        const glm::dvec3 image = operation.image_of(place);
        const bool is_new = std::ranges::none_of(places, [&](const glm::dvec3& other) {
            glm::dvec3 way = image - other;
            for (int i = 0; i < 3; ++i) way[i] -= std::round(way[i]);
            return way_length(cell, way) < same_place;
        });
        if (is_new) places.push_back(image);
    }
}

const Element& element_of(std::string_view symbol, std::string_view name) {
    if (!symbol.empty()) return element_of_species(symbol);
    return element_of_name(name, "", NameColumns::unknown);
}

}  // namespace

cif::Table crystal_atoms(cif::Block& block) {
    const auto words = words_of(site_columns);
    const std::vector<std::string> columns(words.begin(), words.end());
    const cif::Table core = block.find("_atom_site_", columns);
    return core.ok() ? core : block.find("_atom_site.", columns);
}

SphereData read_crystal(const TextSource& source, cif::Table& table, const DataOptions& options) {
    const cif::Item& item = first_item(table);
    const Cell cell = cell_in(source, table.bloc, item);
    std::vector<std::string> warnings;
    const std::vector<SymmetryOperation> operations = operations_in(source, table.bloc, warnings);
    const KeptAlternatives kept = kept_alternatives(table);
    const std::size_t most = table.length() * std::max<std::size_t>(1, operations.size());
    require_memory(most * sizeof(Sphere), source.name + ": up to " + in_groups(most) + " spheres need");
    Atoms atoms;
    atoms.spheres.reserve(table.length());
    enum PropertyPlace : std::size_t { element_place, atom_place, occupancy_place, u_iso_place };
    const std::vector<PropertyColumn> columns = {{"element", PropertyKind::words, element_place},
                                                 {"atom", PropertyKind::words, atom_place},
                                                 {"occupancy", PropertyKind::real, occupancy_place},
                                                 {"u_iso", PropertyKind::real, u_iso_place}};
    PropertyTable properties(columns, options, most, source.name);
    const bool wants_values = properties.wants_rows();
    properties.next_walk();
    std::vector<glm::dvec3> places;
    std::size_t nowhere = 0;
    std::size_t others = 0;
    for (const auto row : table) {
        glm::dvec3 parts;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::string& value = row[axis];
            const double number = number_in(value);
            if (!std::isfinite(number) && !cif::is_null(value)) {
                fail_at_value(source, row, axis,
                              found_expected(value, std::string("fract_") + "xyz"[axis] + " of atom " +
                                                        std::to_string(row.row_index + 1) + " of the table, a number"));
            }
            parts[static_cast<int>(axis)] = number;
        }
        if (!std::isfinite(parts.x + parts.y + parts.z)) {
            ++nowhere;
            continue;
        }
        const std::string_view of = site_text(row, SiteColumn::group);
        if (is_alternative(of) && kept.at(site_text(row, SiteColumn::assembly)).first != of) {
            ++others;
            continue;
        }
        const std::string_view name = site_text(row, SiteColumn::label);
        const Element& element = element_of(site_text(row, SiteColumn::type_symbol), name);
        check_cancelled();  // many atoms and many operations take seconds
        find_places(cell, operations, parts, places);
        if (atoms.spheres.size() + places.size() > most_spheres) {
            throw InputError(source.name + ": found more spheres than can be, expected at most " + in_groups(most_spheres));
        }
        for (const glm::dvec3& place : places) {
            if (is_virtual(element)) atoms.virtual_sites.push_back(atoms.spheres.size());
            const glm::dvec3 center = cell.place(place);
            if (!std::isfinite(center.x + center.y + center.z)) {
                fail_at_value(source, row, 0,
                              "found atom " + std::to_string(row.row_index + 1) +
                                  " of the table beyond what a double can hold, expected its place");
            }
            atoms.spheres.push_back({.center = center, .radius = radius_of(element, options), .color = element.color});
            if (wants_values) {
                properties.add([&](std::size_t value) -> std::string_view {
                    if (value == element_place) return element.symbol.empty() ? name : element.symbol;
                    if (value == atom_place) return name;
                    // Numbers may have their uncertainty in brackets.
                    const std::string_view number =
                        site_text(row, value == occupancy_place ? SiteColumn::occupancy : SiteColumn::u_iso);
                    return number.substr(0, number.find('('));
                });
            }
            if (most <= most_named_atoms) atoms.labels.push_back(name.empty() ? element.symbol : name);
        }
    }
    if (atoms.spheres.empty()) {
        fail_at_tag(source, item, "found a crystal's atoms without places, expected fract_x, fract_y and fract_z as numbers");
    }
    atoms.properties = properties.take();
    SphereData data = data_of(std::move(atoms), source.name, options, as_utf8);
    data.warnings.insert(data.warnings.begin(), warnings.begin(), warnings.end());
    warn_of_left_out(data, nowhere, source.name, "atom", "atoms");
    if (others > 0) {
        data.notes.push_back(source.name + ": " + in_groups(others) + (others == 1 ? " atom is" : " atoms are") +
                             " left out: of disordered groups the fullest is shown");
    }
    return data;
}

}  // namespace sphereview

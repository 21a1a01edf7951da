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

enum class SiteColumn : std::size_t { x, y, z, label, type_symbol, assembly, group, occupancy, u_iso, calc_flag };
constexpr std::string_view site_columns =
    "fract_x fract_y fract_z ?label ?type_symbol ?disorder_assembly ?disorder_group ?occupancy "
    "?U_iso_or_equiv ?calc_flag";

// Images of one atom that are nearer to each other are the same: the atom lies on an element of symmetry, and its numbers are
// rounded. In angstrom, as gemmi has it.
constexpr double same_place = 0.4;

// Twice as many as any space group has.
constexpr std::size_t most_operations = 384;

// The first of the tags that has a value in the block; null if none has, or for ? and a point.
const cif::Item* pair_of(const cif::Block& block, std::initializer_list<const char*> tags) {
    for (const char* tag : tags) {
        const cif::Item* item = block.find_pair_item(tag);
        if (item != nullptr && !cif::is_null(item->pair[1])) return item;
    }
    return nullptr;
}

// Nothing where the block has none.
std::optional<double> number_of(const TextSource& source, const cif::Block& block, std::initializer_list<const char*> tags) {
    const cif::Item* item = pair_of(block, tags);
    if (item == nullptr) return std::nullopt;
    const double number = cif::as_number(cif::as_string(item->pair[1]));
    if (!std::isfinite(number)) fail_at_value(source, *item, found_expected(item->pair[1], item->pair[0] + ", a number"));
    return number;
}

struct CellAngles {
    double alpha, beta, gamma;
};

CellAngles angles_in(const TextSource& source, const cif::Block& block) {
    const auto angle = [&](const char* tag, const char* other) {
        constexpr double right = 90.0;
        return number_of(source, block, {tag, other}).value_or(right);
    };
    return {angle("_cell_angle_alpha", "_cell.angle_alpha"), angle("_cell_angle_beta", "_cell.angle_beta"),
            angle("_cell_angle_gamma", "_cell.angle_gamma")};
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
    const glm::dvec3 lengths = {length({"_cell_length_a", "_cell.length_a"}), length({"_cell_length_b", "_cell.length_b"}),
                                length({"_cell_length_c", "_cell.length_c"})};
    const auto [alpha, beta, gamma] = angles_in(source, block);
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

// gemmi has no decimals in operations: 0.5+x as 12/24+x. Nothing where a number is far from a 24th, of which all shifts are made.
std::optional<std::string> with_fractions(std::string_view triplet) {
    constexpr double unit = gemmi::Op::DEN;
    constexpr double rounded = 0.17;  // 0.66, 0.67 and 0.33 are thirds
    constexpr double most = 100.0;
    std::string result;
    while (!triplet.empty()) {
        const std::size_t end = std::min(triplet.find_first_not_of("0123456789."), triplet.size());
        const std::string_view number = triplet.substr(0, end);
        double value = 0.0;
        if (number.find('.') == std::string_view::npos) {
            result += triplet.substr(0, std::max<std::size_t>(1, end));
        } else if (parse_double(number, value) == NumberFault::none && value < most &&
                   std::abs(unit * value - std::round(unit * value)) < rounded) {
            result += std::to_string(std::lround(unit * value)) + "/" + std::to_string(gemmi::Op::DEN);
        } else {
            return std::nullopt;
        }
        triplet.remove_prefix(std::max<std::size_t>(1, end));
    }
    return result;
}

// "x,y,z" of long numbers would be beyond what gemmi's numbers hold.
std::optional<gemmi::Op> operation_in(const std::string& text) {
    constexpr std::size_t longest = 64;
    if (text.size() > longest) return std::nullopt;
    const std::optional<std::string> triplet = with_fractions(text);
    if (!triplet) return std::nullopt;
    constexpr std::size_t most_digits = 4;
    std::size_t digits = 0;
    for (const char c : *triplet) {
        digits = c >= '0' && c <= '9' ? digits + 1 : 0;
        if (digits > most_digits) return std::nullopt;
    }
    try {
        return gemmi::parse_triplet(*triplet);
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

std::vector<SymmetryOperation> operations_of(const gemmi::GroupOps& group) {
    std::vector<SymmetryOperation> operations;
    for (const gemmi::Op& op : group) operations.emplace_back(op);
    return operations;
}

// By a symbol of Hall; none where it is none.
std::vector<SymmetryOperation> operations_of_hall(const std::string& symbol) {
    try {
        return operations_of(gemmi::symops_from_hall(symbol.c_str()));
    } catch (const std::runtime_error&) {
        return {};
    }
}

// By the name or the number of the space group; none where it is unknown. The angles tell of which cell R is meant: of the
// rhombohedral one all are equal.
std::vector<SymmetryOperation> operations_of_group(const std::string& name, const CellAngles& angles) {
    const gemmi::SpaceGroup* group = gemmi::find_spacegroup_by_name(name, angles.alpha, angles.gamma);
    // gemmi does not look at them where it finds the group by its number.
    if (group != nullptr && is_digits(name)) group = gemmi::find_spacegroup_by_name(group->hm, angles.alpha, angles.gamma);
    return group == nullptr ? std::vector<SymmetryOperation>() : operations_of(group->operations());
}

// What the block says of its space group, the plainest first: Hall's symbol tells the origin and the axes, which a number leaves
// open. Of what is unknown a warning tells. None where the block says nothing.
std::vector<SymmetryOperation> operations_of_named_group(const TextSource& source, const cif::Block& block,
                                                         std::vector<std::string>& warnings) {
    constexpr std::size_t longest_name = 48;
    const cif::Item* unknown = nullptr;
    const cif::Item* hall = pair_of(block, {"_space_group_name_Hall", "_space_group.name_Hall", "_symmetry_space_group_name_Hall",
                                            "_symmetry.space_group_name_Hall"});
    const cif::Item* name = pair_of(block, {"_space_group_name_H-M_alt", "_space_group.name_H-M_alt",
                                            "_symmetry_space_group_name_H-M", "_symmetry.space_group_name_H-M"});
    const cif::Item* number = pair_of(
        block, {"_space_group_IT_number", "_space_group.IT_number", "_symmetry_Int_Tables_number", "_symmetry.Int_Tables_number"});
    for (const cif::Item* item : {hall, name, number}) {
        if (item == nullptr) continue;
        const std::string text = cif::as_string(item->pair[1]);
        std::vector<SymmetryOperation> operations;
        if (text.size() <= longest_name) {
            operations = item == hall ? operations_of_hall(text) : operations_of_group(text, angles_in(source, block));
        }
        if (!operations.empty()) {
            if (unknown != nullptr) {
                warnings.push_back(
                    at_value(source, *unknown,
                             found_expected(cif::as_string(unknown->pair[1]), "a space group that is known; that of ") +
                                 item->pair[0] + " is taken"));
            }
            return operations;
        }
        if (unknown == nullptr) unknown = item;
    }
    if (unknown != nullptr) {
        warnings.push_back(at_value(source, *unknown,
                                    found_expected(cif::as_string(unknown->pair[1]),
                                                   "a space group that is known; only the atoms that are listed are shown")));
    }
    return {};
}

// The operations that the block lists, or those of its space group. None if the block says nothing of symmetry.
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
    return operations_of_named_group(source, block, warnings);
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

const Element& element_of(const cif::Table::Row& row, std::string_view label) {
    if (lower_case(site_text(row, SiteColumn::calc_flag)) == "dum") return virtual_site();
    const std::string_view symbol = site_text(row, SiteColumn::type_symbol);
    return symbol.empty() ? element_of_site(label) : element_of_species(symbol);
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
    enum : std::size_t { element_place, atom_place, occupancy_place, u_iso_place };
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
            if (!std::isfinite(number) && !is_without_number(value)) {
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
        const Element& element = element_of(row, name);
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
                    if (value == element_place) return symbol_or_name(element, name);
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

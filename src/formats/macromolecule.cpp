#include "formats/macromolecule.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "base/text.hpp"
#include "formats/atom_names.hpp"
#include "formats/atoms.hpp"

namespace sphereview {

namespace {

enum class MoleculeField : std::size_t { element, atom, residue, residue_number, chain, b_factor, occupancy, charge, radius };

std::vector<PropertyColumn> molecule_columns(bool has_radii) {
    std::vector<PropertyColumn> columns;
    const auto add = [&](const char* name, PropertyKind kind, MoleculeField field) {
        add_column(columns, name, kind, static_cast<std::size_t>(field));
    };
    add("element", PropertyKind::words, MoleculeField::element);
    add("atom", PropertyKind::words, MoleculeField::atom);
    add("residue", PropertyKind::words, MoleculeField::residue);
    add("residue_number", PropertyKind::whole, MoleculeField::residue_number);
    add("chain", PropertyKind::words, MoleculeField::chain);
    if (!has_radii) add("b_factor", PropertyKind::real, MoleculeField::b_factor);
    if (!has_radii) add("occupancy", PropertyKind::real, MoleculeField::occupancy);
    add("charge", PropertyKind::real, MoleculeField::charge);
    if (has_radii) add("radius", PropertyKind::real, MoleculeField::radius);
    return columns;
}

// "52" of "52A".
std::string_view without_insertion_code(std::string_view number) { return number.substr(0, number.find_last_of("0123456789") + 1); }

std::string name_of(const MoleculeAtom& atom) {
    std::string name;
    if (!atom.chain.empty()) name.append(atom.chain) += '/';
    name.append(atom.residue);
    if (!atom.residue_number.empty()) (name += ' ') += atom.residue_number;
    if (!name.empty()) name += '/';
    name.append(atom.atom);
    return as_utf8(name);
}

using Places = std::vector<const AlternativePlace*>;

// The places of one alternative of a residue.
struct Alternative {
    std::size_t group = 0;  // another alternative with an atom in common, or its own number
    Places places{};

    double occupancy() const {
        const auto of_place = [](const AlternativePlace* place) { return place->occupancy; };
        return of_place(*std::ranges::max_element(places, {}, of_place));
    }
};

std::size_t group_of(std::vector<Alternative>& alternatives, std::size_t number) {
    while (alternatives[number].group != number) {
        alternatives[number].group = alternatives[alternatives[number].group].group;
        number = alternatives[number].group;
    }
    return number;
}

// Appends the spheres of one residue's places that are not kept.
void choose_places(const Places& places, std::vector<std::size_t>& surplus) {
    std::vector<Alternative> alternatives;
    std::map<std::string_view, std::size_t> numbers;  // of alternatives
    std::map<std::string_view, std::size_t> firsts;   // the first alternative that has an atom
    for (const AlternativePlace* place : places) {
        const std::size_t number = numbers.emplace(place->alternative, alternatives.size()).first->second;
        if (number == alternatives.size()) alternatives.push_back({number});
        alternatives[number].places.push_back(place);
        const std::size_t first = firsts.emplace(place->atom, number).first->second;
        alternatives[group_of(alternatives, number)].group = group_of(alternatives, first);
    }

    std::vector<std::size_t> order;  // the fullest first
    for (std::size_t i = 0; i < alternatives.size(); ++i) order.push_back(i);
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return alternatives[i].occupancy(); });
    std::map<std::size_t, std::string_view> residues;         // of each group
    std::map<std::string_view, std::string_view> chosen_for;  // the alternative of each atom
    for (const std::size_t number : order) {
        for (const AlternativePlace* place : alternatives[number].places) {
            const std::string_view residue = residues.emplace(group_of(alternatives, number), place->residue).first->second;
            const bool is_kept = place->residue == residue &&
                                 chosen_for.emplace(place->atom, place->alternative).first->second == place->alternative;
            if (!is_kept) surplus.push_back(place->sphere);
        }
    }
}

}  // namespace

std::vector<std::size_t> surplus_places(std::vector<AlternativePlace> places) {
    const auto address = [](const AlternativePlace& place) { return std::tie(place.chain, place.number); };
    std::ranges::stable_sort(places, {}, address);
    std::vector<std::size_t> surplus;
    for (auto begin = places.begin(); begin != places.end();) {
        const auto is_elsewhere = [&](const AlternativePlace& place) { return address(place) != address(*begin); };
        const auto end = std::find_if(begin, places.end(), is_elsewhere);
        // Of the same number are a residue whose alternatives stand apart, two residues that share a place, and, without a
        // relation, the waters of a chain that are counted from 1 again.
        std::vector<Places> residues;
        std::map<std::size_t, std::size_t> of_run;
        std::map<std::string_view, std::size_t> of_residue;
        for (; begin != end; ++begin) {
            const auto same_run = of_run.find(begin->run);
            const auto same_residue = of_residue.find(begin->residue);
            const std::size_t number = same_run != of_run.end()           ? same_run->second
                                       : same_residue != of_residue.end() ? same_residue->second
                                                                          : residues.size();
            if (number == residues.size()) residues.emplace_back();
            of_run.emplace(begin->run, number);
            of_residue.emplace(begin->residue, number);
            residues[number].push_back(&*begin);
        }
        for (const Places& residue : residues) choose_places(residue, surplus);
    }
    std::ranges::sort(surplus);
    return surplus;
}

MoleculeScene::MoleculeScene(std::size_t atoms, const DataOptions& options, const std::string& name, bool has_radii)
    : named_(atoms <= most_named_atoms),
      options_(options),
      name_(name),
      properties_(molecule_columns(has_radii), options, atoms, name),
      wants_texts_(properties_.wants_rows()) {
    require_memory_for_spheres(name, atoms);
    scene_.spheres.reserve(atoms);
    properties_.next_walk();
}

void MoleculeScene::add_values(const MoleculeAtom& atom) {
    properties_.add([&](std::size_t field) -> std::string_view {
        switch (static_cast<MoleculeField>(field)) {
            case MoleculeField::element: return symbol_or_name(*atom.element, atom.atom);
            case MoleculeField::atom: return atom.atom;
            case MoleculeField::residue: return atom.residue;
            case MoleculeField::residue_number: return without_insertion_code(atom.residue_number);
            case MoleculeField::chain: return atom.chain;
            case MoleculeField::b_factor: return atom.texts.b_factor;
            case MoleculeField::occupancy: return atom.texts.occupancy;
            case MoleculeField::charge: return atom.texts.charge;
            default: return atom.texts.radius;
        }
    });
}

void MoleculeScene::add(const MoleculeAtom& atom) {
    if (atom.chain != chain_ || atom.residue_number != number_) {
        chain_ = atom.chain;
        number_ = atom.residue_number;
        ++run_;
    }
    const std::size_t number = scene_.spheres.size();
    // Without numbers the waters and ions of a chain cannot be told from the places of one.
    const bool is_itself = number_.empty() && (is_water(atom.residue) || is_ion(atom.atom, atom.residue));
    if (!atom.alternative.empty() && !is_itself) {
        places_.push_back(
            {number, run_, atom.chain, atom.residue_number, atom.residue, atom.atom, atom.alternative, atom.occupancy});
    }
    if (is_virtual(*atom.element)) virtual_sites_.push_back(number);
    if (std::string name = named_ ? name_of(atom) : ""; !name.empty()) {
        scene_.names.emplace_hint(scene_.names.end(), static_cast<std::uint32_t>(number), std::move(name));
    }
    const double radius = atom.radius > 0.0 ? atom.radius : radius_of(*atom.element, options_);
    if (wants_texts_) add_values(atom);
    scene_.spheres.push_back({.center = atom.position, .radius = radius, .color = atom.element->color});
}

SphereData MoleculeScene::take() {
    const std::vector<std::size_t> surplus = surplus_places(std::move(places_));
    const std::vector<std::size_t> sites = numbers_without(virtual_sites_, surplus);
    SphereData data{std::move(scene_)};
    add_properties(data, properties_.take());
    remove_spheres(data.scene, surplus);
    settle_virtual_sites(data, sites, name_, options_);
    return data;
}

bool shows_pdb(std::string_view head) {
    const auto records = {"HEADER", "TITLE", "COMPND", "REMARK", "CRYST1", "MODEL", "ATOM", "HETATM"};
    head = trimmed(head, white_space);
    const auto first = words_of(take_line(head));
    return first.size() > 1 && std::find(records.begin(), records.end(), first[0]) != records.end() && !first[1].starts_with('=');
}

bool shows_mmcif(std::string_view head) {
    head = behind_comments(head);
    return head.starts_with("data_") && take_line(head).find('=') == std::string_view::npos;
}

void fail_without_atoms(const TextSource& source, const std::string& expected) {
    source.fail(
        source.text.size(),
        (trimmed(source.text, white_space).empty() ? "the text is empty, expected " : "the text ends, expected ") + expected);
}

}  // namespace sphereview

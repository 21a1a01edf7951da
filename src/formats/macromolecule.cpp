#include "formats/macromolecule.hpp"

#include <algorithm>
#include <utility>

#include "base/text.hpp"

namespace sphereview {

namespace {

std::string name_of(const MoleculeAtom& atom) {
    std::string name;
    if (!atom.chain.empty()) name.append(atom.chain) += '/';
    name.append(atom.residue);
    if (!atom.residue_number.empty()) (name += ' ') += atom.residue_number;
    (name += '/').append(atom.atom);
    return as_utf8(name);
}

}  // namespace

MoleculeScene::MoleculeScene(std::size_t atoms, const DataOptions& options)
    : named_(atoms <= most_named_atoms), radius_(options.radius) {
    scene_.spheres.reserve(atoms);
}

void MoleculeScene::add(const MoleculeAtom& atom) {
    if (atom.chain != chain_ || atom.residue_number != number_) {
        end_residue();
        chain_ = atom.chain;
        number_ = atom.residue_number;
    }
    if (!atom.alternative.empty()) places_.push_back({scene_.spheres.size(), atom.alternative, atom.occupancy});
    if (named_) names_.push_back(name_of(atom));
    scene_.spheres.push_back(
        {.center = atom.position, .radius = radius_.value_or(atom.element->radius), .color = atom.element->color});
}

// Removes the places that are not kept, and names what is left.
void MoleculeScene::end_residue() {
    const auto fullest = std::ranges::max_element(places_, {}, &Place::occupancy);  // the first of several
    auto place = places_.begin();
    std::size_t kept = first_;
    for (std::size_t i = first_; (named_ || !places_.empty()) && i < scene_.spheres.size(); ++i) {
        const bool has_others = place != places_.end() && place->sphere == i;
        if (has_others && (place++)->alternative != fullest->alternative) continue;
        scene_.spheres[kept] = scene_.spheres[i];
        if (named_) scene_.names.emplace_hint(scene_.names.end(), static_cast<std::uint32_t>(kept), std::move(names_[i - first_]));
        ++kept;
    }
    if (named_ || !places_.empty()) scene_.spheres.resize(kept);
    first_ = scene_.spheres.size();
    places_.clear();
    names_.clear();
}

Scene MoleculeScene::take() {
    end_residue();
    return std::move(scene_);
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

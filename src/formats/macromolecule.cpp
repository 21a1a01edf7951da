#include "formats/macromolecule.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace sphereview {

namespace {

// The part of `atoms` that begins at `begin` and is of one residue.
std::span<const MoleculeAtom> residue_at(std::span<const MoleculeAtom> atoms, std::size_t begin) {
    const MoleculeAtom& first = atoms[begin];
    std::size_t end = begin + 1;
    while (end < atoms.size() && atoms[end].chain == first.chain && atoms[end].residue_number == first.residue_number) ++end;
    return atoms.subspan(begin, end - begin);
}

std::string_view fullest_alternative(std::span<const MoleculeAtom> residue) {
    const MoleculeAtom* fullest = nullptr;
    for (const MoleculeAtom& atom : residue) {
        if (atom.alternative.empty()) continue;
        if (fullest == nullptr || atom.occupancy > fullest->occupancy) fullest = &atom;
    }
    return fullest == nullptr ? std::string_view() : fullest->alternative;
}

std::string name_of(const MoleculeAtom& atom) {
    std::string name;
    if (!atom.chain.empty()) name.append(atom.chain) += '/';
    name.append(atom.residue);
    if (!atom.residue_number.empty()) (name += ' ') += atom.residue_number;
    (name += '/').append(atom.atom);
    return as_utf8(name);
}

}  // namespace

Scene scene_of(std::span<const MoleculeAtom> atoms, const DataOptions& options) {
    Scene scene;
    scene.spheres.reserve(atoms.size());
    const bool named = atoms.size() <= most_named_atoms;
    for (std::size_t begin = 0; begin < atoms.size();) {
        const auto residue = residue_at(atoms, begin);
        begin += residue.size();
        const std::string_view kept = fullest_alternative(residue);
        for (const MoleculeAtom& atom : residue) {
            if (!atom.alternative.empty() && atom.alternative != kept) continue;
            if (named) scene.names[static_cast<std::uint32_t>(scene.spheres.size())] = name_of(atom);
            scene.spheres.push_back(
                {.center = atom.position, .radius = options.radius.value_or(atom.element->radius), .color = atom.element->color});
        }
    }
    return scene;
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

#include "formats/atom_lines.hpp"

#include <cmath>

namespace sphereview {

AtomLines step_over_atoms(const TextSource& source, LineWalker& walker, std::size_t count, bool wanted, const std::string& of_frame,
                          GoesOn goes_on, const char* what) {
    const LineWalker first = walker;
    AtomLines lines{count, goes_on, walker.line_end()};
    for (std::size_t i = 0; i < count; ++i) {
        if (walker.at_end()) source.fail_at_end(of_atom(i, count, what).substr(4) + of_frame);
        lines.last = walker.offset();
        if (wanted && i % atom_lines_a_piece == 0) lines.pieces.push_back(walker.offset());
        lines.step(source, walker);
    }
    if (!wanted && walker.at_end()) {
        walker = first;
        return step_over_atoms(source, walker, count, true, of_frame, goes_on, what);
    }
    return lines;
}

std::string of_atom(std::size_t index, std::size_t count, const char* what) {
    return std::string(" of ") + what + " " + std::to_string(index + 1) + " of " + std::to_string(count);
}

void require_finite(const TextSource& source, std::string_view line, const glm::dvec3& center, std::size_t index,
                    std::size_t count) {
    if (std::isfinite(center.x) && std::isfinite(center.y) && std::isfinite(center.z)) return;
    source.fail_at(line,
                   "found a place beyond what a double can hold (at most 1.8e308), expected the place" + of_atom(index, count));
}

void show_as(LineAtom& atom, const Element& element, const DataOptions& options) {
    atom.is_virtual = is_virtual(element);
    atom.sphere.radius = radius_of(element, options);
    atom.sphere.color = element.color;
}

SphereData data_of(Atoms atoms, const std::string& name, const DataOptions& options, std::string (*name_of)(std::string_view)) {
    SphereData data;
    data.scene.spheres = std::move(atoms.spheres);
    for (std::size_t i = 0; i < atoms.labels.size(); ++i) {
        if (atoms.labels[i].empty()) continue;
        data.scene.names.emplace_hint(data.scene.names.end(), static_cast<std::uint32_t>(i), name_of(atoms.labels[i]));
    }
    add_properties(data, std::move(atoms.properties));
    remove_spheres(data.scene, atoms.nowhere);
    warn_of_left_out(data, atoms.nowhere.size(), name, "atom", "atoms");
    settle_virtual_sites(data, numbers_without(atoms.virtual_sites, atoms.nowhere), name, options);
    return data;
}

std::string name_of_species(std::string_view species) {
    const bool number = !species.empty() && species[0] >= '0' && species[0] <= '9';
    const std::string_view symbol = number ? element_of_species(species).symbol : species;
    return as_utf8(symbol.empty() ? species : symbol);
}

}  // namespace sphereview

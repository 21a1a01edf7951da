// The records of PDB, and of formats that borrow them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "formats/atoms.hpp"
#include "formats/lines.hpp"
#include "formats/macromolecule.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

inline bool is_pdb_atom(std::string_view line) { return line.starts_with("ATOM") || line.starts_with("HETATM"); }

// A model that no ENDMDL ends before the next one begins, as where a run was appended to what an ended program had left.
struct InterruptedModel {
    std::int64_t frame = 0;
    std::size_t place = 0;  // of the record MODEL behind it
};

// Where the atoms of the wanted frame stand. Frames are models, or what END separates, as some programs do.
struct PdbFrame {
    std::int64_t frames = 0;  // in the file
    bool has_atoms = false;   // in any
    std::size_t begin = 0;    // of its records
    std::size_t end = 0;
    std::size_t count = 0;  // of its atoms
    std::size_t next = 0;   // where the frame behind it begins, with the title that has its time; 0: there is none
    std::optional<FrameTime> time{};
    std::optional<InterruptedModel> interrupted{};  // the first of those that were looked at
    bool ends_in_model = false;                     // the text's last frame is a model that nothing ends
};

// By `part` it begins behind some frames, which count as looked at.
PdbFrame find_pdb_frame(std::string_view text, std::int64_t wanted, const PartOfFile& part);

// What is wrong where the text ends within its last model: "NAME:LINE:COLUMN: the text ends, expected ..."; else "". An only model
// needs an end, too.
std::string fault_of_last_model(const TextSource& source, const PdbFrame& frame);

// The warning of a model that is interrupted; "" where there is none.
std::string fault_of_interrupted_model(const TextSource& source, const PdbFrame& frame);

// Reads the wanted frame: atom_of(line, wants_texts) makes a MoleculeAtom of each of its records. has_radii: as MoleculeScene's.
template <typename AtomOf>
SphereData read_pdb_frame(const TextSource& source, const DataOptions& options, bool has_radii, const AtomOf& atom_of) {
    const PdbFrame frame = find_pdb_frame(source.text, options.frame, options.part);
    if (!frame.has_atoms) fail_without_atoms(source, "a record ATOM or HETATM");
    require_frame(source.name, options.frame, frame.frames);
    MoleculeScene scene(frame.count, options, source.name, has_radii);
    for (LineWalker lines(source.text.substr(0, frame.end), line_end_of(source.text), frame.begin); !lines.at_end();) {
        const std::string_view line = lines.step();
        if (is_pdb_atom(line)) scene.add(atom_of(line, scene.wants_texts()));
    }
    SphereData data = scene.take();
    data.frames = frame.frames;
    data.next_frame = frame.next;
    data.time = frame.time;
    // A program that was ended while it wrote leaves half a line in the last frame.
    const std::string_view last = last_line(source.text);
    if (frame.end < source.text.size() && !options.part.stops && is_pdb_atom(last)) {
        try {
            atom_of(last, false);
        } catch (const InputError& error) {
            data.fault = error.what();
        }
    }
    // One that was ended between two lines leaves a model without its end.
    if (data.fault.empty()) {
        std::string cut = fault_of_last_model(source, frame);
        if (!cut.empty() && frame.frames == 1) {
            data.warnings.push_back(std::move(cut));
        } else {
            data.fault = std::move(cut);
        }
    }
    if (!data.fault.empty()) {
        if (options.frame + 1 == frame.frames) throw InputError(data.fault);
        data.warnings.push_back(early_end(data.fault, --data.frames));
    }
    if (std::string interrupted = fault_of_interrupted_model(source, frame); !interrupted.empty()) {
        data.warnings.push_back(std::move(interrupted));
        data.cut_frame = frame.interrupted->frame;
    }
    return data;
}

}  // namespace sphereview

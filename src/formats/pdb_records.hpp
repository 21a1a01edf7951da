// The records of PDB, also for formats that use them.
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

// A model without ENDMDL before the next one, as when a run is appended to the output of a program that was ended.
struct InterruptedModel {
    std::int64_t frame = 0;
    std::size_t place = 0;  // of the next record MODEL
};

// The place of the wanted frame's atoms. Frames are models, or, from some programs, separated by END.
struct PdbFrame {
    std::int64_t frames = 0;  // in the file
    bool has_atoms = false;   // in any frame
    std::size_t begin = 0;    // of its records
    std::size_t end = 0;
    std::size_t count = 0;  // of its atoms
    std::size_t next = 0;   // the beginning of the next frame, with the title that has its time; 0: none
    std::optional<FrameTime> time{};
    std::optional<InterruptedModel> interrupted{};  // the first one found
    bool ends_in_model = false;                     // the text's last frame is a model without an end
};

// `part`: begins behind some frames, which count.
PdbFrame find_pdb_frame(std::string_view text, std::int64_t wanted, const PartOfFile& part);

// The fault of a text that ends within its last model, also the only one: "NAME:LINE:COLUMN: the text ends, expected ..."; else "".
std::string fault_of_last_model(const TextSource& source, const PdbFrame& frame);

// The warning about an interrupted model; "" for none.
std::string fault_of_interrupted_model(const TextSource& source, const PdbFrame& frame);

// Reads the wanted frame. atom_of(line, wants_texts) makes a MoleculeAtom of a record. has_radii: MoleculeScene's.
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
    // A program that was ended in the middle of a line leaves half of it.
    const std::string_view last = last_line(source.text);
    if (frame.end < source.text.size() && !options.part.stops && is_pdb_atom(last)) {
        try {
            atom_of(last, false);
        } catch (const InputError& error) {
            data.fault = error.what();
        }
    }
    // A program that was ended between two lines leaves a model without its end.
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

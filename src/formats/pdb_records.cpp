#include "formats/pdb_records.hpp"

#include "base/text.hpp"

namespace sphereview {

namespace {

bool is_record(std::string_view line, std::string_view record) { return trimmed(line.substr(0, 6), " ") == record; }

}  // namespace

PdbFrame find_pdb_frame(std::string_view text, std::int64_t wanted, const PartOfFile& part) {
    PdbFrame found;
    found.frames = part.frames;
    found.has_atoms = part.frames > 0;
    bool open = false;  // more atoms are of the same frame
    for (LineWalker lines(text, line_end_of(text), part.begin); !lines.at_end();) {
        const std::size_t begin = lines.offset();
        const std::string_view line = lines.step();
        if (is_pdb_atom(line)) {
            if (!open) ++found.frames;
            open = found.has_atoms = true;
            if (found.frames - 1 != wanted) continue;
            if (found.count++ == 0) found.begin = begin;
            found.end = lines.offset();
        } else if (is_record(line, "MODEL")) {
            ++found.frames;
            open = true;
        } else if (is_record(line, "ENDMDL") || is_record(line, "END")) {
            open = false;
        }
        if (found.frames - 1 > wanted && found.next == 0) {
            found.next = begin;
            if (part.stops) break;
        }
    }
    return found;
}

}  // namespace sphereview

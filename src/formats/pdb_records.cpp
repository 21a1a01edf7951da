#include "formats/pdb_records.hpp"

#include <optional>
#include <utility>

#include "base/text.hpp"

namespace sphereview {

namespace {

bool is_record(std::string_view line, std::string_view record) { return trimmed(line.substr(0, 6), " ") == record; }

}  // namespace

PdbFrame find_pdb_frame(std::string_view text, std::int64_t wanted, const PartOfFile& part) {
    PdbFrame found;
    found.frames = part.frames;
    found.has_atoms = part.frames > 0;
    bool open = false;              // more atoms are of the same frame
    std::optional<FrameTime> time;  // of the frame to come, as the title above it says,
    std::size_t title = 0;          // which stands there
    const auto begin_frame = [&](std::size_t begin) {
        open = true;
        if (found.frames == wanted) found.time = time;
        if (found.frames == wanted + 1) found.next = time ? title : begin;
        ++found.frames;
        time.reset();
    };
    for (LineWalker lines(text, line_end_of(text), part.begin); !lines.at_end();) {
        const std::size_t begin = lines.offset();
        const std::string_view line = lines.step();
        if (is_pdb_atom(line)) {
            if (!open) begin_frame(begin);
            found.has_atoms = true;
            if (found.frames - 1 == wanted) {
                if (found.count++ == 0) found.begin = begin;
                found.end = lines.offset();
            }
        } else if (is_record(line, "MODEL")) {
            begin_frame(begin);
        } else if (is_record(line, "ENDMDL") || is_record(line, "END")) {
            open = false;
        } else if (!open && is_record(line, "TITLE")) {
            const bool is_first = !time;
            if (auto told = time_in_title(line)) time = std::move(told);
            if (is_first && time) title = begin;
        }
        if (part.stops && found.next > 0) break;
    }
    return found;
}

}  // namespace sphereview

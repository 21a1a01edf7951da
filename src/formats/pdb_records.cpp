#include "formats/pdb_records.hpp"

#include <optional>
#include <string>
#include <utility>

#include "base/text.hpp"

namespace sphereview {

namespace {

bool is_record(std::string_view line, std::string_view record) { return trimmed(line.substr(0, 6), " ") == record; }

// Whether a record ENDMDL ends one of the first two models: some programs write none.
bool has_ends_of_models(std::string_view text) {
    int models = 0;
    for (LineWalker lines(text, line_end_of(text)); !lines.at_end();) {
        const std::string_view line = lines.step();
        if (is_record(line, "ENDMDL")) return true;
        if (is_record(line, "MODEL") && ++models > 2) return false;
    }
    return false;
}

}  // namespace

PdbFrame find_pdb_frame(std::string_view text, std::int64_t wanted, const PartOfFile& part) {
    PdbFrame found;
    found.frames = part.frames;
    found.has_atoms = part.frames > 0;
    bool open = false;              // more atoms are of the same frame
    std::optional<FrameTime> time;  // of the frame to come, as the title above it says,
    std::size_t title = 0;          // which stands there
    bool in_model = false;          // a record MODEL began the frame, and nothing has ended it yet
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
            if (in_model && !found.interrupted) found.interrupted = InterruptedModel{found.frames - 1, begin};
            in_model = true;
            begin_frame(begin);
        } else if (is_record(line, "ENDMDL") || is_record(line, "END")) {
            open = in_model = false;
        } else if (is_record(line, "CONECT") || is_record(line, "MASTER")) {  // which stand behind all models
            in_model = false;
        } else if (!open && is_record(line, "TITLE")) {
            const bool is_first = !time;
            if (auto told = time_in_title(line)) time = std::move(told);
            if (is_first && time) title = begin;
        }
        if (part.stops && found.next > 0) return found;
    }
    found.ends_in_model = in_model;
    return found;
}

std::string fault_of_last_model(const TextSource& source, const PdbFrame& frame) {
    if (!frame.ends_in_model || (frame.frames > 1 && !has_ends_of_models(source.text))) return "";
    return source.place(source.text.size()) + "the text ends, expected ENDMDL of frame " + std::to_string(frame.frames - 1);
}

std::string fault_of_interrupted_model(const TextSource& source, const PdbFrame& frame) {
    if (!frame.interrupted || !has_ends_of_models(source.text)) return "";
    const std::string number = std::to_string(frame.interrupted->frame);
    return source.place(frame.interrupted->place) + "found 'MODEL', expected ENDMDL of frame " + number + " above it; frame " +
           number + " may be cut off";
}

}  // namespace sphereview

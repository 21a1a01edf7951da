// Dumps of LAMMPS in text: for each frame items with a head each, `ITEM: NUMBER OF ATOMS`, and at last `ITEM: ATOMS` with the names
// of the columns behind it.
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "base/text.hpp"
#include "formats/atom_lines.hpp"
#include "formats/cell.hpp"
#include "formats/elements.hpp"
#include "formats/lammps_columns.hpp"
#include "formats/point_radius.hpp"

namespace sphereview {

namespace {

constexpr std::string_view item_head = "ITEM:";

// A style of units of LAMMPS, and its unit of time.
struct DumpUnits {
    std::string_view name;
    std::string_view time;
};
constexpr auto dump_units = std::to_array<DumpUnits>(
    {{"real", "fs"}, {"metal", "ps"}, {"si", "s"}, {"cgs", "s"}, {"electron", "fs"}, {"micro", "us"}, {"nano", "ns"}, {"lj", ""}});

struct DumpFrame {
    std::string_view step{};  // the numbers, "" where the frame has none
    std::string_view time{};
    std::size_t units = 0;                  // PartOfFile::of_first
    std::optional<std::string_view> box{};  // the head of the box, whose lines follow
    std::string_view columns{};             // the head of the atoms
    AtomLines atoms{};
};

// What stands behind ITEM: in a line; nothing for other lines.
std::optional<std::string_view> item_in(std::string_view line) {
    line = trimmed(line, white_space);
    if (!line.starts_with(item_head)) return std::nullopt;
    return trimmed(line.substr(item_head.size()), white_space);
}

class DumpFinder : public FrameFinder {
public:
    using Frame = DumpFrame;
    using FrameFinder::FrameFinder;

    bool next(DumpFrame& frame, std::int64_t number, bool wanted) {
        begin_frame(number);
        std::optional<std::size_t> count;
        std::string_view name;                 // of the units
        std::string_view* value = nullptr;     // of the item that was begun, where it is wanted
        std::optional<std::size_t> box_lines;  // that are still to come, below the head of the box
        bool has_step = false;
        bool begun = false;
        while (!at_end()) {
            const std::string_view line = walker_.step();
            const std::string_view words = trimmed(line, white_space);
            const auto item = item_in(words);
            if (words.empty()) continue;
            if (begun && !item) {
                if (box_lines && (*box_lines)-- == 0) fail_without_head_of_atoms(words);
                if (value != nullptr) *std::exchange(value, nullptr) = words;
                continue;
            }
            if (!item) source_.fail(words.substr(0, words.find_first_of(white_space)), "ITEM: TIMESTEP" + of_frame());
            // What a frame has once would be the next one's.
            const bool is_step = *item == "TIMESTEP";
            const bool is_count = item->starts_with("NUMBER OF ATOMS");
            if ((is_step && has_step) || (is_count && count)) fail_without_head_of_atoms(words);
            has_step = has_step || is_step;
            box_lines.reset();
            begun = true;
            value = is_step ? &frame.step : *item == "TIME" ? &frame.time : *item == "UNITS" ? &name : nullptr;
            if (is_count) {
                count = step_over_count();
            } else if (item->starts_with("BOX BOUNDS")) {
                frame.box = line;
                box_lines = 3;
            } else if (item->starts_with("ATOMS")) {
                if (!count) source_.fail(words, "ITEM: NUMBER OF ATOMS" + of_frame() + " above it");
                note_units(name);
                frame.units = of_first_;
                frame.columns = line;
                frame.atoms = step_over(*count, wanted);
                return true;
            }
        }
        if (begun) source_.fail_at_end("ITEM: ATOMS" + of_frame());
        return false;
    }

    // A line that has fewer words than there are columns is cut.
    bool holds_atom(const DumpFrame& frame, std::string_view line) const {
        if (frame.atoms.count == 0 || source_.offset_of(line) != frame.atoms.last) return true;
        return words_of(line).size() >= names_of_columns(frame.columns).size();
    }

private:
    [[noreturn]] void fail_without_head_of_atoms(std::string_view line) const {
        const std::string_view word = line.substr(0, line.find_first_of(white_space));
        source_.fail(line.starts_with(item_head) ? line : word, "ITEM: ATOMS" + of_frame());
    }

    // LAMMPS writes them once, at the beginning.
    void note_units(std::string_view name) {
        const auto known = std::ranges::find(dump_units, name, &DumpUnits::name);
        if (known != dump_units.end()) of_first_ = static_cast<std::size_t>(known - dump_units.begin()) + 1;
    }
};

// A step's number where that is all there is.
std::optional<FrameTime> time_of_dump(const DumpFrame& frame) {
    if (frame.time.empty()) return frame_time(frame.step, "steps");
    return frame_time(frame.time, frame.units > 0 && frame.units <= dump_units.size() ? dump_units[frame.units - 1].time : "");
}

// Reads the lines of a box: its lowest and highest x, y and z, and the tilts xy, xz and yz where the box is none with right angles,
// whose bounds are then those of the box around it. Or the edges a, b and c with the corner.
Cell read_box(const TextSource& source, std::string_view head, char line_end) {
    const bool is_general = head.find("abc origin") != std::string_view::npos;
    const bool is_tilted = !is_general && head.find("xy") != std::string_view::npos;
    const std::size_t count = is_general ? 4 : is_tilted ? 3 : 2;
    std::array<std::array<double, 4>, 3> numbers{};
    LineWalker walker(source.text, line_end, source.offset_of(head));
    walker.step();
    for (auto& row : numbers) {
        const auto expected = [&] {
            return std::string("the ") + "xyz"[&row - numbers.data()] + " of the box, " + std::to_string(count) + " numbers";
        };
        if (walker.at_end()) source.fail_at_end(expected());
        TokenReader reader(source, walker.step(), parse_any_double);
        for (std::size_t i = 0; i < count; ++i) row[i] = reader.number(expected);
    }
    Cell box;
    if (is_general) {
        box.a = {numbers[0][0], numbers[0][1], numbers[0][2]};
        box.b = {numbers[1][0], numbers[1][1], numbers[1][2]};
        box.c = {numbers[2][0], numbers[2][1], numbers[2][2]};
        box.corner = {numbers[0][3], numbers[1][3], numbers[2][3]};
        return box;
    }
    const double xy = numbers[0][2];
    const double xz = numbers[1][2];
    const double yz = numbers[2][2];
    const double low_x = numbers[0][0] - std::min({0.0, xy, xz, xy + xz});
    const double high_x = numbers[0][1] - std::max({0.0, xy, xz, xy + xz});
    const double low_y = numbers[1][0] - std::min(0.0, yz);
    const double high_y = numbers[1][1] - std::max(0.0, yz);
    box.corner = {low_x, low_y, numbers[2][0]};
    box.a = {high_x - low_x, 0.0, 0.0};
    box.b = {xy, high_y - low_y, 0.0};
    box.c = {xz, yz, numbers[2][1] - numbers[2][0]};
    return box;
}

bool begins_with_letter(std::string_view word) { return !word.empty() && is_letter(word[0]); }

// Whether there are atoms whose element is known, others, and such whose type is more than a number.
struct SeenElements {
    bool known = false;
    bool unknown = false;
    bool labels = false;
};

// Reads the lines of one piece.
class DumpAtomReader {
public:
    // ids: one for each atom, or none. seen: what is met of elements.
    DumpAtomReader(const TextSource& source, const DumpColumns& columns, const Cell& box, std::size_t count,
                   const DataOptions& options, std::vector<std::int64_t>& ids, SeenElements& seen)
        : source_(source),
          columns_(columns),
          has_z_(columns.has(DumpField::z)),
          is_scaled_(columns.is_scaled()),
          is_mixed_(columns.is_mixed()),
          box_(box),
          count_(count),
          options_(options),
          ids_(ids),
          seen_(seen) {}

    LineAtom read(std::string_view line, std::size_t index) {
        TokenReader reader(source_, line, parse_any_double);
        const OfAtom the{index, count_};
        LineAtom atom;
        glm::dvec3& center = atom.sphere.center;
        std::string_view type;
        std::string_view element_name;
        double radius = 0.0;
        bool is_placed = true;
        std::size_t at = 0;
        for (const auto& [field, place] : columns_.columns) {
            reader.skip_tokens(place - at);
            at = place + 1;
            switch (field) {
                case DumpField::id: ids_[index] = reader.integer(lowest_id, highest_id, the("id")); break;
                case DumpField::type: type = reader.word(the("type")); break;
                case DumpField::element: element_name = reader.word(the("element")); break;
                case DumpField::x: is_placed = reader.number_if_any(the("x"), center.x) && is_placed; break;
                case DumpField::y: is_placed = reader.number_if_any(the("y"), center.y) && is_placed; break;
                case DumpField::z: is_placed = reader.number_if_any(the("z"), center.z) && is_placed; break;
                case DumpField::radius: radius = reader.number_or(0.0, the("radius")); break;
                case DumpField::diameter: radius = 0.5 * reader.number_or(0.0, the("diameter")); break;
            }
        }
        atom.is_nowhere = !is_placed;
        if (atom.is_nowhere) center = glm::dvec3(0.0);
        set_place(center);
        require_finite(source_, line, center, index, count_);
        // Types may have labels, which often are elements.
        const bool is_number = element_name.empty() && !begins_with_letter(type);
        atom.label = element_name.empty() ? type : element_name;
        const Element& element = is_number ? unknown_element() : element_of_species(atom.label);
        if (!is_number) note(seen_.labels);
        if (!is_virtual(element)) note(&element == &unknown_element() ? seen_.unknown : seen_.known);
        show_as(atom, element, options_);
        if (radius > 0.0) atom.sphere.radius = radius;
        std::uint64_t number = 0;
        if (is_number && parse_whole(type, number) && number > 0) atom.sphere.color = color_of_type(number);
        return atom;
    }

private:
    // Other cores may write beside it: once only.
    static void note(bool& seen) {
        if (!seen) seen = true;
    }

    void set_place(glm::dvec3& center) const {
        if (is_mixed_) {
            const std::array<double, 3> edges = {box_.a.x, box_.b.y, box_.c.z};
            for (int axis = 0; axis < 3; ++axis) {
                const auto at = static_cast<std::size_t>(axis);
                if (columns_.scaled[at]) center[axis] = center[axis] * edges[at] + box_.corner[axis];
            }
        } else if (is_scaled_) {
            center = box_.place(center);
        }
        if (!has_z_) center.z = 0.0;
    }

    static constexpr std::int64_t lowest_id = std::numeric_limits<std::int64_t>::min();
    static constexpr std::int64_t highest_id = std::numeric_limits<std::int64_t>::max();

    const TextSource& source_;
    const DumpColumns& columns_;
    bool has_z_;
    bool is_scaled_;
    bool is_mixed_;
    const Cell& box_;
    std::size_t count_;  // of the frame's atoms
    const DataOptions& options_;
    std::vector<std::int64_t>& ids_;
    SeenElements& seen_;
};

// Gives the atoms, which are in the order of the lines, the colours of their labels, which are no elements: in alphabetical
// order, so that they stay from frame to frame. place: of the labels' column.
void color_by_label(Atoms& atoms, const TextSource& source, const AtomLines& lines, std::size_t place) {
    std::map<std::string_view, std::uint64_t> numbers;
    const auto each_label = [&](const auto& visit) {
        if (lines.count == 0) return;
        LineWalker walker = lines.walker(source, 0);
        std::vector<std::string_view> words;
        for (std::size_t i = 0; i < lines.count; ++i) {
            words.clear();
            split_line(walker.step(), place + 1, words);
            if (begins_with_letter(words[place])) visit(i, words[place]);
        }
    };
    each_label([&](std::size_t, std::string_view label) { numbers.emplace(label, 0); });
    std::uint64_t next = 0;
    for (auto& [label, number] : numbers) number = next++;
    each_label([&](std::size_t i, std::string_view label) { atoms.spheres[i].color = color_of_type(numbers.at(label) + 1); });
}

// Puts the atoms in the order of their ids, which many processors have mixed.
void order_by_id(Atoms& atoms, const std::vector<std::int64_t>& ids) {
    if (std::ranges::is_sorted(ids)) return;
    std::vector<std::uint32_t> order(ids.size());  // from: the atom that belongs at each place
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return ids[i]; });
    for (Property& property : atoms.properties.kept) property = values_of(property, order);
    std::vector<std::uint32_t> new_places;
    if (!atoms.virtual_sites.empty() || !atoms.nowhere.empty()) {
        new_places.resize(order.size());
        for (std::size_t i = 0; i < order.size(); ++i) new_places[order[i]] = static_cast<std::uint32_t>(i);
        for (std::vector<std::size_t>* numbers : {&atoms.virtual_sites, &atoms.nowhere}) {
            for (std::size_t& number : *numbers) number = new_places[number];
            std::ranges::sort(*numbers);
        }
    }
    // In place, one ring of places after the other: twice the spheres would be much memory.
    for (std::size_t first = 0; first < order.size(); ++first) {
        const Sphere sphere = atoms.spheres[first];
        const std::string_view label = atoms.labels.empty() ? std::string_view() : atoms.labels[first];
        std::size_t to = first;
        while (order[to] != to) {
            const std::size_t from = order[to];
            order[to] = static_cast<std::uint32_t>(to);
            const bool closes = from == first;
            atoms.spheres[to] = closes ? sphere : atoms.spheres[from];
            if (!atoms.labels.empty()) atoms.labels[to] = closes ? label : atoms.labels[from];
            if (closes) break;
            to = from;
        }
    }
}

std::string name_of_dump_atom(std::string_view label) {
    return begins_with_letter(label) ? name_of_species(label) : "type " + as_utf8(label);
}

SphereData read_dump_frame(const TextSource& source, const DumpFrame& frame, const DataOptions& options) {
    const std::size_t count = frame.atoms.count;
    DumpColumns columns = dump_columns(source, frame.columns, frame.atoms);
    const bool has_ids = columns.has(DumpField::id);
    const std::size_t bytes_of_order = has_ids ? sizeof(std::int64_t) + sizeof(std::uint32_t) : 0;
    require_memory_for_spheres(source.name, count, sizeof(Sphere) + bytes_of_order);
    Cell box;
    if (columns.is_scaled()) {
        if (!frame.box) source.fail_at(frame.columns, "found places in parts of a box, expected ITEM: BOX BOUNDS above them");
        box = read_box(source, *frame.box, frame.atoms.line_end);
        if (columns.is_mixed() && !box.has_right_angles()) {
            source.fail_at(frame.columns, "found places in parts of a tilted box beside others, expected all of one kind");
        }
    }
    std::vector<std::int64_t> ids(has_ids ? count : 0);
    std::vector<SeenElements> seen(frame.atoms.pieces.size());
    Atoms atoms = read_atom_lines(source, frame.atoms, [&](std::size_t piece) {
        return DumpAtomReader(source, columns, box, count, options, ids, seen[piece]);
    });
    // Labels of types often are elements; beside one that is none, B is no boron.
    const bool has_known = std::ranges::any_of(seen, &SeenElements::known);
    const bool has_unknown = std::ranges::any_of(seen, &SeenElements::unknown);
    const bool has_elements = has_known && (columns.has(DumpField::element) || !has_unknown);
    const auto type = std::ranges::find(columns.columns, DumpField::type, &DumpColumn::field);
    const auto element = std::ranges::find(columns.columns, DumpField::element, &DumpColumn::field);
    const auto label = element != columns.columns.end() ? element : type;
    if (!has_elements) {
        // X is a type, too, and no smaller than the others.
        for (const std::size_t site : atoms.virtual_sites) {
            if (options.radius) atoms.spheres[site].radius = *options.radius;
        }
        atoms.virtual_sites.clear();
        if (std::ranges::any_of(seen, &SeenElements::labels)) color_by_label(atoms, source, frame.atoms, label->place);
    }
    if (has_elements && !columns.has(DumpField::element) && type != columns.columns.end()) {
        add_column(columns.properties, "element", PropertyKind::element, type->place);
    }
    atoms.properties = read_word_properties(source, frame.atoms, columns.properties, options);
    if (has_ids) order_by_id(atoms, ids);
    SphereData data = data_of(std::move(atoms), source.name, options, name_of_dump_atom);
    data.time = time_of_dump(frame);
    const bool has_radii = columns.has(DumpField::radius) || columns.has(DumpField::diameter);
    if (!has_radii && !has_elements) use_radius_of_points(data, source.name, options);
    return data;
}

}  // namespace

bool shows_lammps(std::string_view head) {
    const auto item = item_in(head.substr(0, head.find_first_of("\r\n")));
    return item && (item->starts_with("TIMESTEP") || item->starts_with("UNITS") || item->starts_with("TIME"));
}

SphereData read_lammps(std::string_view content, const std::string& name, const DataOptions& options) {
    return read_frame_of<DumpFinder>(content, name, options, "ITEM: TIMESTEP", read_dump_frame);
}

std::optional<std::size_t> step_over_lammps(std::string_view text, bool ended, const std::string& name, PartOfFile& part) {
    return step_over_frame<DumpFinder>(text, ended, name, part, read_dump_frame);
}

}  // namespace sphereview

// mmCIF (PDBx): gemmi's grammar of CIF, with actions that take only the table of atoms and know where everything stands.
#include <algorithm>
#include <array>
#include <gemmi/cif.hpp>
#include <unordered_map>

#include "base/available_memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/macromolecule.hpp"

namespace sphereview {

namespace {

namespace pegtl = tao::pegtl;
namespace rules = gemmi::cif::rules;

constexpr std::string_view table_name = "_atom_site.";

enum Column : std::size_t {
    x,
    y,
    z,
    type_symbol,
    auth_atom_id,
    label_atom_id,
    auth_comp_id,
    label_comp_id,
    auth_asym_id,
    label_asym_id,
    auth_seq_id,
    label_seq_id,
    insertion_code,
    alternative,
    occupancy,
    model,
    column_count
};
constexpr std::array<std::string_view, column_count> column_names = {
    "cartn_x",           "cartn_y",       "cartn_z",      "type_symbol",       "auth_atom_id", "label_atom_id",
    "auth_comp_id",      "label_comp_id", "auth_asym_id", "label_asym_id",     "auth_seq_id",  "label_seq_id",
    "pdbx_pdb_ins_code", "label_alt_id",  "occupancy",    "pdbx_pdb_model_num"};

// The text of a value; "" of "." and "?", which stand for none.
std::string_view text_of(std::string_view value) {
    if (value == "." || value == "?") return "";
    const bool quoted = value.size() > 1 && (value.front() == '"' || value.front() == '\'') && value.back() == value.front();
    return quoted ? value.substr(1, value.size() - 2) : value;
}

// A number, perhaps with its standard uncertainty behind it: "1.234(5)".
NumberFault number_of(std::string_view value, double& number) {
    value = text_of(value);
    if (value.ends_with(')')) value = value.substr(0, value.find('('));
    return parse_double(value, number);
}

// Collects the atoms of the wanted frame.
class AtomTable {
public:
    AtomTable(std::string_view content, const std::string& name, std::int64_t wanted)
        : content_(content), name_(name), wanted_(wanted) {}

    void begin_loop() {
        tags_.clear();
        next_value_ = 0;
        is_table_ = false;
    }

    void take_loop_tag(std::string_view tag) {
        const bool own = begins_table(tag);
        if (own && !is_table_) begin_table(tag);
        is_table_ = is_table_ || own;
        tags_.push_back(own ? column_of(tag) : column_count);
    }

    void take_loop_value(std::string_view value) {
        if (is_table_) {
            if (const Column column = tags_[next_value_]; column != column_count) row_[column] = value;
        }
        last_value_ = value;
        if (++next_value_ < tags_.size()) return;
        next_value_ = 0;
        if (is_table_) take_row();
    }

    void end_loop() {
        if (next_value_ != 0) {
            const std::string values = next_value_ == 1 ? " value" : " values";
            const std::string found = std::to_string(next_value_) + values + " in the last row of a table";
            fail(last_value_, found, std::to_string(tags_.size()));
        }
        is_table_ = false;
    }

    // A table of one row may be written as pairs of a tag and a value.
    void take_pair_tag(std::string_view tag) {
        pair_ = column_count;
        if (!begins_table(tag)) return;
        if (!in_pairs_) begin_table(tag);
        in_pairs_ = true;
        pair_ = column_of(tag);
    }

    void take_pair_value(std::string_view value) {
        if (pair_ != column_count) row_[pair_] = value;
        pair_ = column_count;
    }

    void finish() {
        if (in_pairs_) take_row();
        if (models_.empty()) fail_without_atoms(content_, name_, "the table _atom_site with Cartn_x, Cartn_y and Cartn_z");
    }

    const std::vector<MoleculeAtom>& atoms() const { return atoms_; }
    std::int64_t frames() const { return static_cast<std::int64_t>(models_.size()); }

private:
    [[noreturn]] void fail(std::string_view place, const std::string& found, const std::string& expected) const {
        fail_at(content_, name_, static_cast<std::size_t>(place.data() - content_.data()),
                "found " + found + ", expected " + expected);
    }

    bool begins_table(std::string_view tag) const {
        if (tag.size() < table_name.size()) return false;
        const std::string begin = lower_case(tag.substr(0, table_name.size()));
        if (begin == "_atom_site_" && lower_case(tag) == "_atom_site_fract_x") {
            fail(tag, in_quotes(tag) + ", of a crystal in fractional coordinates", "mmCIF with _atom_site.Cartn_x");
        }
        return begin == table_name;
    }

    void begin_table(std::string_view tag) {
        if (table_.data() != nullptr) fail(tag, "a second table of atoms", "one");
        table_ = tag;
    }

    Column column_of(std::string_view tag) const {
        const auto found = std::ranges::find(column_names, lower_case(tag.substr(table_name.size())));
        return static_cast<Column>(found - column_names.begin());
    }

    void take_row() {
        for (const Column column : {x, y, z}) {
            if (row_[column].data() == nullptr)
                fail(table_, "a table of atoms without one of their places", "Cartn_x, Cartn_y and Cartn_z");
        }
        // A file's models follow each other.
        const std::string_view name = text_of(row_[model]);
        if (models_.empty() || name != last_model_) {
            last_redraw_ = models_.emplace(name, models_.size()).first->second;
            last_model_ = name;
        }
        if (static_cast<std::int64_t>(last_redraw_) == wanted_) take_atom();
    }

    void take_atom() {
        MoleculeAtom atom;
        atom.position = {coordinate(x, "x"), coordinate(y, "y"), coordinate(z, "z")};
        atom.atom = first_of(auth_atom_id, label_atom_id);
        const std::string_view symbol = text_of(row_[type_symbol]);
        atom.element = &element_of_species(symbol.empty() ? atom.atom : symbol);
        atom.chain = first_of(auth_asym_id, label_asym_id);
        atom.residue = first_of(auth_comp_id, label_comp_id);
        atom.residue_number = std::string(first_of(auth_seq_id, label_seq_id)).append(text_of(row_[insertion_code]));
        atom.alternative = text_of(row_[alternative]);
        double part = 1.0;
        if (number_of(row_[occupancy], part) == NumberFault::none) atom.occupancy = part;
        atoms_.push_back(std::move(atom));
    }

    double coordinate(Column column, const char* what) const {
        double value = 0.0;
        const std::string_view text = row_[column];
        if (number_of(text, value) != NumberFault::none)
            fail(text, in_quotes(text), std::string("the atom's ") + what + ", a number");
        return value;
    }

    std::string_view first_of(Column column, Column other) const {
        const std::string_view text = text_of(row_[column]);
        return text.empty() ? text_of(row_[other]) : text;
    }

    std::string_view content_;
    const std::string& name_;
    std::int64_t wanted_;
    std::vector<Column> tags_{};  // of the loop that is being read
    std::size_t next_value_ = 0;  // in its row
    std::string_view last_value_{};
    bool is_table_ = false;  // the loop is the table of atoms
    bool in_pairs_ = false;  // the table is no loop
    Column pair_ = column_count;
    std::string_view table_{};  // its first tag
    std::array<std::string_view, column_count> row_{};
    std::unordered_map<std::string_view, std::size_t> models_{};
    std::string_view last_model_{};
    std::size_t last_redraw_ = 0;
    std::vector<MoleculeAtom> atoms_{};
};

template <typename Input>
std::string_view matched(const Input& in) {
    return {in.begin(), in.size()};
}

template <typename Rule>
struct Action : pegtl::nothing<Rule> {};

template <>
struct Action<rules::str_loop> {
    template <typename Input>
    static void apply(const Input&, AtomTable& table) {
        table.begin_loop();
    }
};

template <>
struct Action<rules::loop_tag> {
    template <typename Input>
    static void apply(const Input& in, AtomTable& table) {
        table.take_loop_tag(matched(in));
    }
};

template <>
struct Action<rules::loop_value> {
    template <typename Input>
    static void apply(const Input& in, AtomTable& table) {
        table.take_loop_value(matched(in));
    }
};

template <>
struct Action<rules::loop> {
    template <typename Input>
    static void apply(const Input&, AtomTable& table) {
        table.end_loop();
    }
};

template <>
struct Action<rules::item_tag> {
    template <typename Input>
    static void apply(const Input& in, AtomTable& table) {
        table.take_pair_tag(matched(in));
    }
};

template <>
struct Action<rules::item_value> {
    template <typename Input>
    static void apply(const Input& in, AtomTable& table) {
        table.take_pair_value(matched(in));
    }
};

// Where the grammar does not go on, and why.
struct SyntaxFault {
    const char* place;
    std::string why;
};

template <typename Rule>
struct Control : pegtl::normal<Rule> {
    template <typename Input, typename... States>
    [[noreturn]] static void raise(const Input& in, States&&...) {
        throw SyntaxFault{in.current(), gemmi::cif::error_message<Rule>()};
    }
};

[[noreturn]] void fail_syntax(std::string_view content, const std::string& name, const SyntaxFault& fault) {
    const auto offset = static_cast<std::size_t>(fault.place - content.data());
    const std::string_view rest = content.substr(offset);
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n"));
    const std::string found = rest.empty() ? "the text ends" : "found " + in_quotes(word);
    const bool unterminated = fault.why.starts_with("unterminated");
    if (unterminated) fail_at(content, name, offset, "found an " + fault.why + ", expected its end");
    const bool in_block = fault.why.find("data_") == std::string::npos;
    fail_at(content, name, offset, found + ", expected " + (in_block ? "CIF: a tag, a value or loop_" : "a data block, data_NAME"));
}

}  // namespace

SphereData read_mmcif(std::string_view content, const std::string& name, const DataOptions& options) {
    // Beside the text: our atoms and the spheres, from lines of some 90 bytes, and room for them to grow.
    require_memory(content.size() / 90 * (2 * sizeof(MoleculeAtom) + sizeof(Sphere)), name + ": its atoms need");
    AtomTable table(content, name, options.frame);
    const std::string_view text = without_byte_order_mark(content);
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) table.finish();
    pegtl::memory_input<> input(text.data(), text.size(), name);
    try {
        pegtl::parse<rules::file, Action, Control>(input, table);
    } catch (const SyntaxFault& fault) {
        fail_syntax(content, name, fault);
    }
    table.finish();
    require_frame(name, options.frame, table.frames());
    return {scene_of(table.atoms(), options), table.frames()};
}

}  // namespace sphereview

// PLY: the points of the element `vertex`, as text or as bytes. Faces and other elements are passed over.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "formats/atom_lines.hpp"
#include "formats/atoms.hpp"
#include "formats/csv_values.hpp"
#include "formats/ply_header.hpp"
#include "formats/point_radius.hpp"

namespace sphereview {

namespace {

enum PlyField : std::size_t { ply_x, ply_y, ply_z, ply_radius, ply_diameter, ply_red, ply_green, ply_blue, no_field };
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

PlyField field_named(std::string_view name) {
    struct Named {
        std::string_view name;
        PlyField field;
    };
    constexpr auto names = std::to_array<Named>({{"x", ply_x},
                                                 {"y", ply_y},
                                                 {"z", ply_z},
                                                 {"radius", ply_radius},
                                                 {"scalar_radius", ply_radius},
                                                 {"pscale", ply_radius},
                                                 {"diameter", ply_diameter},
                                                 {"red", ply_red},
                                                 {"green", ply_green},
                                                 {"blue", ply_blue},
                                                 {"diffuse_red", ply_red},
                                                 {"diffuse_green", ply_green},
                                                 {"diffuse_blue", ply_blue},
                                                 {"r", ply_red},
                                                 {"g", ply_green},
                                                 {"b", ply_blue}});
    const auto found = std::ranges::find(names, lower_case(name), &Named::name);
    return found == names.end() ? no_field : found->field;
}

// Which properties of vertices are drawn.
struct DrawnVertices {
    std::array<std::optional<std::size_t>, no_field> places{};  // among all, of each field
    bool whole_colors = true;
    double full_color = color_max;  // what stands for 255

    bool has(PlyField field) const { return places[field].has_value(); }
    bool has_color() const { return has(ply_red) && has(ply_green) && has(ply_blue); }
    bool holds(std::size_t place) const { return std::ranges::find(places, std::optional(place)) != places.end(); }
};

DrawnVertices drawn_of(const TextSource& source, const PlyElement& element) {
    DrawnVertices drawn;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        const PlyField field = property.count_type ? no_field : field_named(property.name);
        if (field == no_field || drawn.has(field)) continue;
        drawn.places[field] = i;
        if (field == ply_red) drawn.whole_colors = is_whole(property.type);
    }
    if (!drawn.has(ply_x) || !drawn.has(ply_y)) {
        source.fail_at(element.name, "found vertices without x and y, expected these among their properties");
    }
    drawn.full_color = drawn.whole_colors ? color_max : 1.0;
    return drawn;
}

bool is_blank_line(std::string_view, std::string_view rest) {
    const std::size_t word = rest.find_first_not_of(" \t\r\v\f");
    return word == std::string_view::npos || rest[word] == '\n';
}

template <typename Number>
double number_at(const char* bytes, bool swapped) {
    std::array<char, sizeof(Number)> copy{};
    std::memcpy(copy.data(), bytes, copy.size());
    if (swapped) std::ranges::reverse(copy);
    return static_cast<double>(std::bit_cast<Number>(copy));
}

double number_at(const char* bytes, PlyType type, bool swapped) {
    switch (type) {
        case PlyType::int8: return number_at<std::int8_t>(bytes, swapped);
        case PlyType::uint8: return number_at<std::uint8_t>(bytes, swapped);
        case PlyType::int16: return number_at<std::int16_t>(bytes, swapped);
        case PlyType::uint16: return number_at<std::uint16_t>(bytes, swapped);
        case PlyType::int32: return number_at<std::int32_t>(bytes, swapped);
        case PlyType::uint32: return number_at<std::uint32_t>(bytes, swapped);
        case PlyType::float32: return number_at<float>(bytes, swapped);
        default: return number_at<double>(bytes, swapped);
    }
}

// What the value of a property is wanted for: to be drawn it must be a number, or stand for none, and as a coordinate also be one
// that a double can hold.
enum class PlyUse : std::uint8_t { none, kept, drawn, coordinate };

// Finds the vertices of a file, text or bytes, and reads what their properties say.
class VertexReader {
public:
    // Throws InputError where the file ends too early.
    VertexReader(const TextSource& source, const PlyHeader& header, const PlyElement& vertex)
        : source_(source),
          vertex_(vertex),
          is_text_(header.encoding == PlyEncoding::ascii),
          swapped_((header.encoding == PlyEncoding::big_endian) != (std::endian::native == std::endian::big)) {
        // Blank lines belong to the element before them, and those behind the header to none.
        const std::size_t first = std::min(source.text.find_first_not_of(white_space, header.end), source.text.size());
        const std::size_t line = source.text.substr(0, first).rfind(header.line_end) + 1;  // 0 where there is none
        const std::size_t begin = std::max(header.end, line);
        LineWalker walker(source.text, header.line_end, begin);
        std::size_t next = header.end;
        for (const PlyElement& before : header.elements) {
            if (&before == &vertex) break;
            if (is_text_) {
                step_over_atoms(source, walker, before.count, false, " of " + in_quotes(before.name), is_blank_line, "element");
            } else {
                next = skip(before, 0, before.count, next);
            }
        }
        if (is_text_) {
            lines_ = step_over_atoms(source, walker, vertex.count, true, "", is_blank_line, "vertex");
            return;
        }
        lines_.count = vertex.count;
        for (std::size_t first = 0; first < vertex.count; first += atom_lines_a_piece) {
            lines_.pieces.push_back(next);
            next = skip(vertex, first, std::min(vertex.count, first + atom_lines_a_piece), next);
        }
    }

    // How many pieces each() reads, at once.
    std::size_t pieces() const { return lines_.pieces.size(); }

    // Calls visit(piece, index, values) for each vertex, with a value for each property that `uses` has a use for: `nothing` where
    // it is no finite number. Throws InputError.
    template <typename Visit>
    void each(const std::vector<PlyUse>& uses, const Visit& visit) const {
        parallel_in_order(pieces(), [&](std::size_t piece) {
            std::vector<double> values(uses.size(), nothing);
            LineWalker walker = lines_.walker(source_, piece);
            std::size_t next = lines_.pieces[piece];
            const std::size_t first = piece * atom_lines_a_piece;
            const std::size_t last = std::min(lines_.count, first + atom_lines_a_piece);
            for (std::size_t i = first; i < last; ++i) {
                if (is_text_) {
                    read_line(lines_.step(source_, walker), i, uses, values);
                } else {
                    next = read_bytes(next, i, uses, values);
                }
                visit(piece, i, values);
            }
        });
    }

private:
    void read_line(std::string_view line, std::size_t index, const std::vector<PlyUse>& uses, std::vector<double>& values) const {
        TokenReader reader(source_, line, parse_any_double);
        for (std::size_t k = 0; k < uses.size(); ++k) {
            const PlyProperty& property = vertex_.properties[k];
            const auto expected = [&] { return in_quotes(property.name) + of_atom(index, vertex_.count, "vertex"); };
            if (property.count_type) {
                const auto most = static_cast<std::int64_t>(line.size());
                reader.skip_tokens(static_cast<std::size_t>(reader.integer(0, most, expected)));
            } else if (uses[k] == PlyUse::drawn) {
                values[k] = reader.number_or(nothing, expected);
            } else if (uses[k] == PlyUse::coordinate) {
                if (!reader.number_if_any(expected, values[k])) values[k] = nothing;
            } else {
                values[k] = nothing;
                if (uses[k] == PlyUse::kept) parse_any_double(reader.token(), values[k]);
                reader.skip_tokens(1);
            }
        }
    }

    // Returns where the vertex ends that begins at `at`.
    std::size_t read_bytes(std::size_t at, std::size_t index, const std::vector<PlyUse>& uses, std::vector<double>& values) const {
        for (std::size_t k = 0; k < uses.size(); ++k) {
            const PlyProperty& property = vertex_.properties[k];
            if (uses[k] != PlyUse::none) values[k] = number_at(source_.text.data() + at, property.type, swapped_);
            at = property.count_type ? skip_list(property, vertex_, index, at) : at + size_of(property.type);
        }
        return at;
    }

    // Where element `last` begins, when `first` begins at `at`.
    std::size_t skip(const PlyElement& element, std::size_t first, std::size_t last, std::size_t at) const {
        if (element.has_lists()) {
            for (; first < last; ++first) {
                for (const PlyProperty& property : element.properties) {
                    if (property.count_type) {
                        at = skip_list(property, element, first, at);
                    } else {
                        at = behind(1, size_of(property.type), element, first, at);
                    }
                }
            }
            return at;
        }
        const std::size_t size = element.size();
        return size == 0 ? at : behind(last - first, size, element, first + (source_.text.size() - at) / size, at);
    }

    std::size_t skip_list(const PlyProperty& property, const PlyElement& element, std::size_t index, std::size_t at) const {
        const std::size_t values = behind(1, size_of(*property.count_type), element, index, at);
        const double count = number_at(source_.text.data() + at, *property.count_type, swapped_);
        if (count < 0.0) source_.fail(at, "found a list of " + shortest(count) + " values, expected 0 or more");
        return behind(static_cast<std::size_t>(count), size_of(property.type), element, index, values);
    }

    // Where so many values of that size end which begin at `at`. `missing`: the element that is not whole where the file ends
    // before.
    std::size_t behind(std::size_t count, std::size_t size, const PlyElement& element, std::size_t missing, std::size_t at) const {
        if ((source_.text.size() - at) / size >= count) return at + count * size;
        source_.fail(source_.text.size(), "the file ends, expected " + in_quotes(element.name) + " " + std::to_string(missing + 1) +
                                              " of " + std::to_string(element.count));
    }

    const TextSource& source_;
    const PlyElement& vertex_;
    bool is_text_;
    bool swapped_;
    AtomLines lines_{};  // or where the pieces of bytes begin
};

// What the vertices of one piece say beside their spheres.
struct VertexNotes {
    std::vector<std::size_t> nowhere{};  // the numbers of those without a place, ascending
    double largest_color = 0.0;
};

Sphere sphere_of(const std::vector<double>& values, const DrawnVertices& drawn, const DataOptions& options, std::size_t index,
                 VertexNotes& notes) {
    const auto value_of = [&](PlyField field) { return drawn.has(field) ? values[*drawn.places[field]] : nothing; };
    Sphere sphere;
    sphere.center = {value_of(ply_x), value_of(ply_y), drawn.has(ply_z) ? value_of(ply_z) : 0.0};
    if (!std::isfinite(sphere.center.x) || !std::isfinite(sphere.center.y) || !std::isfinite(sphere.center.z)) {
        notes.nowhere.push_back(index);
        sphere.center = glm::dvec3(0.0);
    }
    const double radius = value_of(ply_radius);
    const double own = radius > 0.0 ? radius : 0.5 * value_of(ply_diameter);
    sphere.radius = own > 0.0 && std::isfinite(own) ? own : options.radius.value_or(1.0);
    if (!drawn.has_color()) return sphere;
    const auto channel = [&](PlyField field) {
        const double value = value_of(field);
        if (value <= most_of_color) notes.largest_color = std::max(notes.largest_color, value);
        return color_byte(value, drawn.full_color);
    };
    const auto red = channel(ply_red);
    const auto green = channel(ply_green);
    const auto blue = channel(ply_blue);
    if (red && green && blue) sphere.color = {*red, *green, *blue};
    return sphere;
}

std::vector<VertexNotes> read_spheres(const VertexReader& vertices, const PlyElement& element, const DrawnVertices& drawn,
                                      const DataOptions& options, std::vector<Sphere>& spheres) {
    std::vector<PlyUse> uses(element.properties.size(), PlyUse::none);
    for (std::size_t field = 0; field < drawn.places.size(); ++field) {
        if (drawn.places[field]) uses[*drawn.places[field]] = field <= ply_z ? PlyUse::coordinate : PlyUse::drawn;
    }
    std::vector<VertexNotes> notes(vertices.pieces());
    spheres.resize(element.count);
    vertices.each(uses, [&](std::size_t piece, std::size_t i, const std::vector<double>& values) {
        spheres[i] = sphere_of(values, drawn, options, i, notes[piece]);
    });
    return notes;
}

// What stands for 255 in the colours. Of whole numbers the header says more than a table does: they are no parts of 1, and what is
// larger than a byte has 16 bits.
double full_color_of(const DrawnVertices& drawn, const std::vector<VertexNotes>& notes) {
    double largest = 0.0;
    for (const VertexNotes& note : notes) largest = std::max(largest, note.largest_color);
    if (drawn.whole_colors) return largest > color_max ? most_of_color : color_max;
    return full_color(largest);
}

// Values of a property at its own size.
decltype(Property::values) values_for(PlyType type, std::size_t count) {
    if (type == PlyType::float32) return std::vector<float>(count);
    if (is_whole(type) && type != PlyType::uint32) return std::vector<std::int32_t>(count);
    return std::vector<double>(count);
}

// Reads the properties that are asked for.
void read_vertex_properties(const TextSource& source, const VertexReader& vertices, const PlyElement& element,
                            const DrawnVertices& drawn, const DataOptions& options, SphereData& data) {
    std::vector<PropertyColumn> columns;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const bool is_size = drawn.places[ply_radius] == i || drawn.places[ply_diameter] == i;
        const bool is_drawn = drawn.holds(i) && !is_size;
        if (element.properties[i].count_type || is_drawn) continue;
        add_column(columns, element.properties[i].name, PropertyKind::found, i);
    }
    for (const PropertyColumn& column : columns) data.property_names.push_back(column.name);
    std::erase_if(columns, [&](const PropertyColumn& column) { return !is_wanted(options, column.name, element.count); });
    if (columns.empty()) return;
    require_memory(columns.size() * element.count * sizeof(double),
                   source.name + ": the values of " + in_groups(element.count) + " vertices need");
    std::vector<PlyUse> uses(element.properties.size(), PlyUse::none);
    std::vector<Property>& kept = data.scene.properties;
    for (const PropertyColumn& column : columns) {
        uses[column.place] = PlyUse::kept;
        kept.push_back({column.name, values_for(element.properties[column.place].type, element.count)});
    }
    vertices.each(uses, [&](std::size_t, std::size_t i, const std::vector<double>& values) {
        for (std::size_t k = 0; k < kept.size(); ++k) set_number(kept[k], i, values[columns[k].place]);
    });
}

}  // namespace

bool shows_ply(std::string_view head) { return take_line(head) == "ply"; }

SphereData read_ply(std::string_view content, const std::string& name, const DataOptions& options) {
    TextSource source{name, without_byte_order_mark(content)};
    const PlyHeader header = read_ply_header(source);
    if (header.encoding == PlyEncoding::ascii) source.text = without_end_marks(source.text);
    const auto element = std::ranges::find(header.elements, "vertex", &PlyElement::name);
    if (element == header.elements.end()) source.fail(header.end, "found no element vertex, expected one in the header");
    DrawnVertices drawn = drawn_of(source, *element);
    // No vertex takes less than a byte: what is claimed beyond that is not there.
    const std::size_t most = std::min(element->count, source.text.size());
    if (most > most_spheres)
        throw InputError(name + ": found " + in_groups(most) + " vertices, expected at most " + in_groups(most_spheres));
    require_memory(most * sizeof(Sphere), name + ": up to " + in_groups(most) + " spheres need");
    const VertexReader vertices(source, header, *element);
    SphereData data;
    std::vector<VertexNotes> notes = read_spheres(vertices, *element, drawn, options, data.scene.spheres);
    if (const double full = full_color_of(drawn, notes); full != drawn.full_color) {
        drawn.full_color = full;
        notes = read_spheres(vertices, *element, drawn, options, data.scene.spheres);
    }
    std::vector<std::size_t> nowhere;
    for (const VertexNotes& note : notes) nowhere.insert(nowhere.end(), note.nowhere.begin(), note.nowhere.end());
    read_vertex_properties(source, vertices, *element, drawn, options, data);
    remove_spheres(data.scene, nowhere);
    if (!drawn.has(ply_z)) data.warnings.push_back(name + ": no property z: all lie in the plane z = 0");
    warn_of_left_out(data, nowhere.size(), name, "vertex", "vertices");
    if (!drawn.has(ply_radius) && !drawn.has(ply_diameter)) use_radius_of_points(data, name, options);
    return data;
}

}  // namespace sphereview

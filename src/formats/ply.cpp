// PLY: the points of the element `vertex`, as text or as bytes. Faces and other elements are passed over.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "formats/atom_lines.hpp"
#include "formats/atoms.hpp"
#include "formats/ply_header.hpp"
#include "formats/point_radius.hpp"

namespace sphereview {

namespace {

enum PlyField : std::size_t { ply_x, ply_y, ply_z, ply_radius, ply_diameter, ply_red, ply_green, ply_blue, no_field };
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// What a vertex says; `nothing` where it does not.
using VertexValues = std::array<double, no_field>;

// A property of vertices, and what it says of a sphere.
struct VertexProperty {
    PlyProperty property;
    PlyField field;
};

// What of vertices is drawn.
struct Vertices {
    std::vector<VertexProperty> properties{};  // all, in the file's order
    std::size_t count = 0;
    double full_color = color_max;  // what stands for 255
    bool whole_colors = true;
    bool has_radius = false;
    bool has_color = false;
};

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

Vertices vertices_of(const TextSource& source, const PlyElement& element) {
    Vertices vertices;
    vertices.count = element.count;
    std::array<bool, no_field + 1> has{};
    for (const PlyProperty& property : element.properties) {
        PlyField field = property.count_type ? no_field : field_named(property.name);
        if (has[field]) field = no_field;
        has[field] = true;
        vertices.properties.push_back({property, field});
        if (field == ply_red) vertices.whole_colors = is_whole(property.type);
    }
    if (!has[ply_x] || !has[ply_y] || !has[ply_z]) {
        throw InputError(source.place(element.name) + "found vertices without x, y and z, expected these among their properties");
    }
    vertices.has_radius = has[ply_radius] || has[ply_diameter];
    vertices.has_color = has[ply_red] && has[ply_green] && has[ply_blue];
    vertices.full_color = vertices.whole_colors ? color_max : 1.0;
    return vertices;
}

// What the vertices of one piece say beside their spheres.
struct VertexNotes {
    std::vector<std::size_t> nowhere{};  // the numbers of those without a place, ascending
    double largest_color = 0.0;
};

Sphere sphere_of(const VertexValues& values, const Vertices& vertices, const DataOptions& options, std::size_t index,
                 VertexNotes& notes) {
    Sphere sphere;
    sphere.center = {values[ply_x], values[ply_y], values[ply_z]};
    if (!std::isfinite(values[ply_x]) || !std::isfinite(values[ply_y]) || !std::isfinite(values[ply_z])) {
        notes.nowhere.push_back(index);
        sphere.center = glm::dvec3(0.0);
    }
    const double own = values[ply_radius] > 0.0 ? values[ply_radius] : 0.5 * values[ply_diameter];
    sphere.radius = own > 0.0 && std::isfinite(own) ? own : options.radius.value_or(1.0);
    if (!vertices.has_color) return sphere;
    const auto channel = [&](PlyField field) {
        const double value = values[field];
        if (std::isfinite(value)) notes.largest_color = std::max(notes.largest_color, value);
        const double part = value > 0.0 ? std::min(1.0, value / vertices.full_color) : 0.0;
        return static_cast<std::uint8_t>(std::lround(color_max * part));
    };
    sphere.color = {channel(ply_red), channel(ply_green), channel(ply_blue)};
    return sphere;
}

// A number that is not finite is none, and no fault: scanners write it for points that they did not see.
NumberFault parse_or_nothing(std::string_view token, double& value) {
    const NumberFault fault = parse_any_double(token, value);
    if (fault == NumberFault::not_a_number) return fault;
    if (fault != NumberFault::none) value = nothing;
    return NumberFault::none;
}

// Reads the lines of one piece.
class PlyLineReader {
public:
    PlyLineReader(const TextSource& source, const Vertices& vertices, const DataOptions& options, VertexNotes& notes)
        : text_(source.text), line_{source.name, {}}, vertices_(vertices), options_(options), notes_(notes) {}

    LineAtom read(std::size_t begin, std::size_t end, std::size_t index) {
        line_.text = text_.substr(0, end);
        TokenReader reader(line_, begin, line_ends, parse_or_nothing);
        VertexValues values;
        values.fill(nothing);
        for (const VertexProperty& next : vertices_.properties) {
            const auto expected = [&] { return in_quotes(next.property.name) + of_atom(index, vertices_.count, "vertex"); };
            if (next.property.count_type) {
                const auto most = static_cast<std::int64_t>(end - begin);
                reader.skip_tokens(static_cast<std::size_t>(reader.integer(0, most, expected)));
            } else if (next.field == no_field) {
                reader.skip_tokens(1);
            } else {
                values[next.field] = reader.number(expected);
            }
        }
        return {sphere_of(values, vertices_, options_, index, notes_)};
    }

private:
    std::string_view text_;
    TextSource line_;  // the text up to the line's end
    const Vertices& vertices_;
    const DataOptions& options_;
    VertexNotes& notes_;
};

// A property of vertices that is kept, at its own size.
struct KeptVertexProperty {
    std::size_t place;  // among all
    Property property;
};

std::vector<KeptVertexProperty> kept_properties(const Vertices& vertices, const DataOptions& options,
                                                std::vector<std::string>& names) {
    std::vector<PropertyColumn> columns;
    for (std::size_t i = 0; i < vertices.properties.size(); ++i) {
        const auto& [property, field] = vertices.properties[i];
        const bool is_drawn = field != no_field && field != ply_radius && field != ply_diameter;
        if (!property.count_type && !is_drawn) add_column(columns, property.name, PropertyKind::found, i);
    }
    std::vector<KeptVertexProperty> kept;
    for (const PropertyColumn& column : columns) {
        names.push_back(column.name);
        if (!is_wanted(options, column.name, vertices.count)) continue;
        Property property{column.name, std::vector<double>{}};
        const PlyType type = vertices.properties[column.place].property.type;
        if (type == PlyType::float32) property.values = std::vector<float>{};
        if (is_whole(type) && type != PlyType::uint32) property.values = std::vector<std::int32_t>{};
        kept.push_back({column.place, std::move(property)});
    }
    return kept;
}

// What is not finite is no value.
void append(Property& property, double value) {
    if (auto* const numbers = std::get_if<std::vector<float>>(&property.values)) {
        const auto number = static_cast<float>(value);
        numbers->push_back(std::isfinite(number) ? number : std::numeric_limits<float>::quiet_NaN());
    } else if (auto* const wholes = std::get_if<std::vector<std::int32_t>>(&property.values)) {
        const bool fits = value > no_whole_number && value <= std::numeric_limits<std::int32_t>::max();
        wholes->push_back(fits ? static_cast<std::int32_t>(value) : no_whole_number);
    } else {
        std::get<std::vector<double>>(property.values).push_back(std::isfinite(value) ? value : nothing);
    }
}

// The values of a line, one for each of the properties, lists passed over.
void read_line_values(std::string_view line, const Vertices& vertices, std::vector<std::string_view>& words,
                      std::vector<double>& values) {
    words.clear();
    split_line(line, line.size(), words);
    values.assign(vertices.properties.size(), nothing);
    std::size_t at = 0;
    for (std::size_t i = 0; i < values.size() && at < words.size(); ++i, ++at) {
        std::size_t count = 0;
        if (!vertices.properties[i].property.count_type) {
            parse_or_nothing(words[at], values[i]);
        } else if (parse_whole(words[at], count)) {
            at += std::min(count, words.size() - at);
        }
    }
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

// Walks through the elements of a binary file.
class BytesReader {
public:
    BytesReader(const TextSource& source, const PlyHeader& header)
        : source_(source),
          swapped_((header.encoding == PlyEncoding::big_endian) != (std::endian::native == std::endian::big)),
          next_(header.end) {}

    void skip(const PlyElement& element) {
        if (!element.has_lists()) {
            require(element, element.count);
            next_ += element.count * element.size();
            return;
        }
        for (std::size_t i = 0; i < element.count; ++i) {
            for (const PlyProperty& property : element.properties) skip(property, element, i);
        }
    }

    // Where each vertex begins; with lists only one after the other tells.
    std::vector<Sphere> vertices(const PlyElement& element, const Vertices& vertices, const DataOptions& options,
                                 std::vector<VertexNotes>& notes) {
        std::vector<Sphere> spheres;
        if (element.has_lists()) {
            notes.resize(1);
            for (std::size_t i = 0; i < element.count; ++i) {
                VertexValues values;
                values.fill(nothing);
                for (const auto& [property, field] : vertices.properties) {
                    const std::size_t at = next_;
                    skip(property, element, i);
                    if (field != no_field) values[field] = number_at(source_.text.data() + at, property.type, swapped_);
                }
                spheres.push_back(sphere_of(values, vertices, options, i, notes[0]));
            }
            return spheres;
        }
        require(element, element.count);
        spheres.resize(element.count);
        constexpr std::size_t piece_size = 16'384;
        notes.resize(element.count / piece_size + 1);
        const std::size_t stride = element.size();
        parallel_for(notes.size(), [&](std::size_t piece) {
            const std::size_t end = std::min(element.count, (piece + 1) * piece_size);
            for (std::size_t i = piece * piece_size; i < end; ++i) {
                const char* at = source_.text.data() + next_ + i * stride;
                VertexValues values;
                values.fill(nothing);
                for (const auto& [property, field] : vertices.properties) {
                    if (field != no_field) values[field] = number_at(at, property.type, swapped_);
                    at += size_of(property.type);
                }
                spheres[i] = sphere_of(values, vertices, options, i, notes[piece]);
            }
        });
        return spheres;
    }

    // Of the vertices that begin here, all of which are there.
    void append_values(const PlyElement& element, std::vector<KeptVertexProperty>& kept) {
        std::vector<std::size_t> places(element.properties.size());
        for (std::size_t i = 0; i < element.count; ++i) {
            for (std::size_t k = 0; k < places.size(); ++k) {
                places[k] = next_;
                skip(element.properties[k], element, i);
            }
            for (auto& [place, property] : kept) {
                append(property, number_at(source_.text.data() + places[place], element.properties[place].type, swapped_));
            }
        }
    }

private:
    std::size_t left() const { return source_.text.size() - next_; }

    [[noreturn]] void fail_at_end(const PlyElement& element, std::size_t index) const {
        source_.fail(source_.text.size(), "the file ends, expected " + in_quotes(element.name) + " " + std::to_string(index + 1) +
                                              " of " + std::to_string(element.count));
    }

    // That there are the bytes of `count` elements without lists.
    void require(const PlyElement& element, std::size_t count) const {
        const std::size_t size = element.size();
        if (size > 0 && left() / size < count) fail_at_end(element, left() / size);
    }

    void skip(const PlyProperty& property, const PlyElement& element, std::size_t index) {
        const std::size_t size = size_of(property.type);
        std::size_t values = 1;
        if (property.count_type) {
            const std::size_t of_count = size_of(*property.count_type);
            if (left() < of_count) fail_at_end(element, index);
            const double count = number_at(source_.text.data() + next_, *property.count_type, swapped_);
            if (count < 0.0) source_.fail(next_, "found a list of " + shortest(count) + " values, expected 0 or more");
            next_ += of_count;
            values = static_cast<std::size_t>(count);
        }
        if (left() / size < values) fail_at_end(element, index);
        next_ += values * size;
    }

    const TextSource& source_;
    bool swapped_;
    std::size_t next_;
};

// Where the lines of an element of a text stand.
AtomLines lines_of(const TextSource& source, const PlyHeader& header, const PlyElement& element) {
    LineWalker walker(source.text, header.line_end, header.end);
    for (const PlyElement& before : header.elements) {
        if (&before == &element) break;
        step_over_atoms(source, walker, before.count, false, " of " + in_quotes(before.name), is_blank_line, "element");
    }
    return step_over_atoms(source, walker, element.count, true, "", is_blank_line, "vertex");
}

// Reads the vertices that the header describes, with what they are painted with.
std::vector<Sphere> read_vertices(const TextSource& source, const PlyHeader& header, const PlyElement& element,
                                  const Vertices& vertices, const DataOptions& options, std::vector<VertexNotes>& notes) {
    if (header.encoding != PlyEncoding::ascii) {
        BytesReader bytes(source, header);
        for (const PlyElement& before : header.elements) {
            if (&before == &element) break;
            bytes.skip(before);
        }
        return bytes.vertices(element, vertices, options, notes);
    }
    const AtomLines lines = lines_of(source, header, element);
    notes.resize(lines.pieces.size());
    const auto reader = [&](std::size_t piece) { return PlyLineReader(source, vertices, options, notes[piece]); };
    return read_atom_lines(source, lines, header.line_end, reader).spheres;
}

// Reads the properties that are asked for, of vertices that were read.
void read_properties_of(const TextSource& source, const PlyHeader& header, const PlyElement& element, const Vertices& vertices,
                        const DataOptions& options, SphereData& data) {
    std::vector<KeptVertexProperty> kept = kept_properties(vertices, options, data.property_names);
    if (kept.empty()) return;
    require_memory(kept.size() * element.count * sizeof(double),
                   source.name + ": the values of " + in_groups(element.count) + " vertices need");
    if (header.encoding != PlyEncoding::ascii) {
        BytesReader bytes(source, header);
        for (const PlyElement& before : header.elements) {
            if (&before == &element) break;
            bytes.skip(before);
        }
        bytes.append_values(element, kept);
    } else {
        const AtomLines lines = lines_of(source, header, element);
        LineWalker walker(source.text, header.line_end, lines.count > 0 ? lines.pieces[0] : 0);
        std::vector<std::string_view> words;
        std::vector<double> values;
        for (std::size_t i = 0; i < lines.count; ++i) {
            const std::size_t begin = walker.offset();
            const std::size_t end = walker.step();
            step_over_rest(source, walker, lines.goes_on, begin, end);
            read_line_values(source.text.substr(begin, end - begin), vertices, words, values);
            for (auto& [place, property] : kept) append(property, values[place]);
        }
    }
    for (KeptVertexProperty& one : kept) data.scene.properties.push_back(std::move(one.property));
}

// What stands for 255 in the colours: of whole numbers 255, or 65535 where one is larger; else 1, or 255 likewise.
double full_color_of(const Vertices& vertices, const std::vector<VertexNotes>& notes) {
    constexpr double most_of_one = 1.5;
    constexpr double most_of_short = 65535.0;
    double largest = 0.0;
    for (const VertexNotes& note : notes) largest = std::max(largest, note.largest_color);
    if (vertices.whole_colors) return largest > color_max ? most_of_short : color_max;
    return largest > most_of_one ? color_max : 1.0;
}

}  // namespace

bool shows_ply(std::string_view head) { return take_line(head) == "ply"; }

SphereData read_ply(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, without_byte_order_mark(content)};
    const PlyHeader header = read_ply_header(source);
    const auto element = std::ranges::find(header.elements, "vertex", &PlyElement::name);
    if (element == header.elements.end()) source.fail(header.end, "found no element vertex, expected one in the header");
    Vertices vertices = vertices_of(source, *element);
    // No vertex takes less than a byte: what is claimed beyond that is not there.
    const std::size_t most = std::min(element->count, source.text.size());
    if (most > most_spheres)
        throw InputError(name + ": found " + in_groups(most) + " vertices, expected at most " + in_groups(most_spheres));
    require_memory(most * sizeof(Sphere), name + ": up to " + in_groups(most) + " spheres need");
    std::vector<VertexNotes> notes;
    SphereData data;
    data.scene.spheres = read_vertices(source, header, *element, vertices, options, notes);
    if (const double full = full_color_of(vertices, notes); full != vertices.full_color) {
        vertices.full_color = full;
        notes.clear();
        data.scene.spheres = read_vertices(source, header, *element, vertices, options, notes);
    }
    std::vector<std::size_t> nowhere;
    for (const VertexNotes& note : notes) nowhere.insert(nowhere.end(), note.nowhere.begin(), note.nowhere.end());
    read_properties_of(source, header, *element, vertices, options, data);
    remove_spheres(data.scene, nowhere);
    if (!nowhere.empty()) {
        data.warnings.push_back(name + ": " + in_groups(nowhere.size()) + (nowhere.size() == 1 ? " vertex has" : " vertices have") +
                                " no coordinates and " + (nowhere.size() == 1 ? "is" : "are") + " left out");
    }
    if (!vertices.has_radius && !options.radius) use_radius_of_points(data, name);
    return data;
}

}  // namespace sphereview

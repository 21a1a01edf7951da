// The text format: N, then for each sphere `R G B`, `x y z`, `radius`, separated by white space and line ends of any kind.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/input_file.hpp"
#include "base/progress.hpp"
#include "formats/lines.hpp"
#include "formats/sphere_data.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// Reads a text as it comes in, on all cores. Memory grows with the text, not with the count that it claims. First each core counts
// the tokens that begin in its piece; then each piece's spheres are known, and all pieces are read at once.
class SphereTextReader {
public:
    // `size`: bytes of the whole text, if known.
    SphereTextReader(std::string name, TextPosition origin, std::optional<std::size_t> size, std::size_t piece = usual_line_piece)
        : name_(std::move(name)), place_(origin), size_(size), piece_(piece) {}

    // A sphere's memory, including later uses, so that a scene too large is refused at once.
    void expect_bytes_per_sphere(std::size_t bytes) { bytes_per_sphere_ = bytes; }

    // Reads the spheres that end inside `text`; `last`: nothing follows. Returns the number of bytes that are done; the next call's
    // text begins with the others. Skips a byte-order mark. Throws InputError "NAME:LINE:COLUMN: found ..., expected ..." for the
    // first fault, and MemoryError when the spheres cannot fit.
    std::size_t read(std::string_view text, bool last);

    // The part of the spheres that was read, 0..1.
    double fraction() const;

    // All spheres, after the last text.
    std::vector<Sphere> take_spheres() { return std::move(spheres_); }

private:
    std::size_t read_whole_tokens(std::string_view text, bool last);
    void read_count(TokenReader& reader, std::optional<std::size_t> bytes_left);
    std::size_t read_pieces(const TextSource& source, std::size_t begin, TextPosition& place);
    Sphere read_sphere(TokenReader& reader, std::size_t index) const;

    std::string name_;
    TextPosition place_;  // the beginning of the next call's text
    std::optional<std::size_t> size_;
    std::size_t piece_;
    std::size_t bytes_per_sphere_ = sizeof(Sphere);
    std::size_t done_ = 0;  // bytes of earlier calls
    std::optional<std::size_t> count_{};
    std::vector<Sphere> spheres_{};
};

// Reads the spheres of a whole text. Throws as SphereTextReader::read.
std::vector<Sphere> parse_text_spheres(const TextSource& source);

// The spheres as text, which parse_text_spheres reads back bit for bit.
std::string write_text_spheres(const std::vector<Sphere>& spheres);

// The functions of the table of formats. Hidden spheres are not written.
bool shows_text(std::string_view head);
SphereData read_text(std::string_view content, const std::string& name, const DataOptions& options);
std::string write_text(const Scene& scene);
Scene stream_text(InputStream& stream, std::size_t bytes_per_sphere, Progress* progress);

}  // namespace sphereview

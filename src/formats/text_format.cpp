#include "formats/text_format.hpp"

#include <algorithm>

#include "base/memory.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

constexpr std::size_t tokens_of_sphere = 7;
constexpr std::size_t shortest_sphere = 14;  // seven digits, each with a separator

// How much of a stream is read at a time: it stays in the processor's cache, and keeps many cores at work.
constexpr std::size_t block = std::size_t{1} << 22;

constexpr std::size_t spheres_begun_before(std::size_t token) { return (token + tokens_of_sphere - 1) / tokens_of_sphere; }

// How many tokens begin in [begin, end) of a text; at `first` stands nothing or white space before the text's first token.
std::size_t tokens_begun(std::string_view text, std::size_t first, std::size_t begin, std::size_t end) {
    if (begin == end) return 0;
    const auto begins = [bytes = text.data()](std::size_t i) {
        const bool behind_space = is_space(bytes[i - 1]);
        const bool in_token = !is_space(bytes[i]);
        return behind_space & in_token;
    };
    const bool at_once = begin == first ? !is_space(text[begin]) : begins(begin);
    return (at_once ? 1 : 0) + count_places(begin + 1, end, begins);
}

// Where `text` ends that begins at `origin`, when it would end at `end` if it began at 1:1.
TextPosition moved_to(TextPosition origin, TextPosition end) {
    if (end.line == 1) return {origin.line, origin.column + end.column - 1};
    return {origin.line + end.line - 1, end.column};
}

// What one core read: whole spheres, from the first that begins in its piece.
struct Piece {
    std::size_t end = 0;    // where the next sphere begins; 0 when there are none
    TextPosition extent{};  // where its text ends, were 1:1 its beginning
};

}  // namespace

std::size_t SphereTextReader::read(std::string_view text, bool last) {
    if (!last) {
        // The last white space is left for the next call: so no token is cut in two, and no line end.
        std::size_t cut = text.find_last_of(white_space);
        if (cut == std::string_view::npos) return 0;
        if (cut > 0 && text[cut] == '\n' && text[cut - 1] == '\r') --cut;
        text = text.substr(0, cut);
    }
    std::size_t mark = 0;
    if (done_ == 0) mark = text.size() - without_byte_order_mark(text).size();
    const std::size_t used = mark + read_whole_tokens(text.substr(mark), last);
    done_ += used;
    return used;
}

std::size_t SphereTextReader::read_whole_tokens(std::string_view text, bool last) {
    const TextSource source{name_, text, place_};
    TokenReader reader(source, 0);
    if (!count_ && !reader.at_end()) read_count(reader, last ? done_ + text.size() : size_);
    if (!count_ && last) reader.fail_at_end("the text is empty", "the number of spheres");
    std::size_t end = reader.offset();
    TextPosition place = position_at(text, end, place_);
    if (count_) {
        end = read_pieces(source, end, place);
        TokenReader rest(source, end);
        // Too few tokens for another sphere: one of them is wrong, or one is missing.
        if (last && spheres_.size() < *count_) read_sphere(rest, spheres_.size());
        if (spheres_.size() == *count_ && !rest.at_end()) {
            rest.fail("the end of the text after " + std::to_string(*count_) + (*count_ == 1 ? " sphere" : " spheres"));
        }
    }
    place_ = place;
    return end;
}

void SphereTextReader::read_count(TokenReader& reader, std::optional<std::size_t> bytes) {
    const auto expected = [] { return std::string("the number of spheres"); };
    if (reader.token().starts_with('#')) reader.fail(expected() + ": only TOML has comments, the text format has none");
    count_ = static_cast<std::size_t>(reader.integer(0, most_spheres, expected));
    std::size_t most = *count_;
    if (bytes) most = std::min(most, (*bytes - std::min(*bytes, done_ + reader.offset())) / shortest_sphere + 1);
    require_memory(most * bytes_per_sphere_, name_ + ": " + in_groups(most) + " spheres need");
    if (bytes) spheres_.reserve(most);
}

std::size_t SphereTextReader::read_pieces(const TextSource& source, std::size_t begin, TextPosition& place) {
    const std::string_view text = source.text;
    const std::size_t count = (text.size() - begin + piece_ - 1) / piece_;
    const auto begin_of = [&](std::size_t piece) { return std::min(text.size(), begin + piece * piece_); };

    std::vector<std::size_t> tokens_before(count + 1);
    parallel_for(count, [&](std::size_t i) { tokens_before[i + 1] = tokens_begun(text, begin, begin_of(i), begin_of(i + 1)); });
    for (std::size_t i = 0; i < count; ++i) tokens_before[i + 1] += tokens_before[i];

    const std::size_t earlier = spheres_.size();
    const std::size_t here = std::min(tokens_before[count] / tokens_of_sphere, *count_ - earlier);
    spheres_.resize(earlier + here);
    std::vector<Piece> pieces(count);
    parallel_in_order(count, [&](std::size_t i) {
        const std::size_t first = std::min(here, spheres_begun_before(tokens_before[i]));
        const std::size_t last = std::min(here, spheres_begun_before(tokens_before[i + 1]));
        if (first == last) return;
        std::size_t offset = begin_of(i);
        if (offset > begin && !is_space(text[offset - 1])) {  // inside a token of the piece before
            while (!is_space(text[offset])) ++offset;
        }
        TokenReader reader(source, offset);
        reader.skip_tokens(first * tokens_of_sphere - tokens_before[i]);
        const std::size_t own = reader.offset();
        for (std::size_t s = earlier + first; s < earlier + last; ++s) spheres_[s] = read_sphere(reader, s);
        pieces[i].end = reader.offset();
        pieces[i].extent = position_at(text.substr(own), pieces[i].end - own);
    });

    std::size_t end = begin;
    for (const Piece& piece : pieces) {
        if (piece.end == 0) continue;
        end = piece.end;
        place = moved_to(place, piece.extent);
    }
    return end;
}

Sphere SphereTextReader::read_sphere(TokenReader& reader, std::size_t index) const {
    const auto of_sphere = [&](const char* what) {
        return [this, what, index] {
            return std::string(what) + " of sphere " + std::to_string(index + 1) + " of " + std::to_string(*count_);
        };
    };
    Sphere sphere;
    sphere.color.r = static_cast<std::uint8_t>(reader.integer(0, color_max, of_sphere("the red")));
    sphere.color.g = static_cast<std::uint8_t>(reader.integer(0, color_max, of_sphere("the green")));
    sphere.color.b = static_cast<std::uint8_t>(reader.integer(0, color_max, of_sphere("the blue")));
    sphere.center.x = reader.number(of_sphere("the centre's x"));
    sphere.center.y = reader.number(of_sphere("the centre's y"));
    sphere.center.z = reader.number(of_sphere("the centre's z"));
    sphere.radius = reader.positive_number(of_sphere("the radius"));
    return sphere;
}

double SphereTextReader::fraction() const {
    if (!count_ || *count_ == 0) return 0.0;
    return static_cast<double>(spheres_.size()) / static_cast<double>(*count_);
}

std::vector<Sphere> parse_text_spheres(const TextSource& source) {
    SphereTextReader reader(source.name, source.origin, source.text.size());
    reader.read(source.text, true);
    return reader.take_spheres();
}

std::string write_text_spheres(const std::vector<Sphere>& spheres) {
    std::string text = std::to_string(spheres.size()) + "\n";
    for (const auto& [center, radius, color, hidden] : spheres) {
        text += std::to_string(color.r) + ' ' + std::to_string(color.g) + ' ' + std::to_string(color.b) + '\n';
        text += shortest(center.x);
        text += ' ';
        text += shortest(center.y);
        text += ' ';
        text += shortest(center.z);
        text += '\n';
        text += shortest(radius);
        text += '\n';
    }
    return text;
}

bool shows_text(std::string_view head) {
    head = trimmed(head, white_space);
    return !head.empty() && std::string_view("0123456789+-.").find(head[0]) != std::string_view::npos;
}

SphereData read_text(std::string_view content, const std::string& name, const DataOptions&) {
    SphereData read;
    read.scene.spheres = parse_text_spheres({name, without_end_marks(content)});
    return read;
}

std::string write_text(const Scene& scene) {
    const auto is_hidden = [](const Sphere& sphere) { return sphere.hidden; };
    if (std::none_of(scene.spheres.begin(), scene.spheres.end(), is_hidden)) return write_text_spheres(scene.spheres);
    std::vector<Sphere> shown = scene.spheres;
    std::erase_if(shown, is_hidden);
    return write_text_spheres(shown);
}

Scene stream_text(InputStream& stream, std::size_t bytes_per_sphere, Progress* progress) {
    SphereTextReader reader(stream.name(), {}, stream.size());
    reader.expect_bytes_per_sphere(bytes_per_sphere);
    while (true) {
        const std::string_view text = stream.ended() ? without_end_marks(stream.bytes()) : stream.bytes();
        stream.drop_first(reader.read(text, stream.ended()));
        if (stream.ended()) break;
        if (progress != nullptr) progress->update(reader.fraction());
        stream.fill(std::max(block, 2 * stream.bytes().size()));  // more than a block when a token has not ended in it
    }
    Scene scene;
    scene.spheres = reader.take_spheres();
    return scene;
}

}  // namespace sphereview

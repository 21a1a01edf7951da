#include "formats/frame_reader.hpp"

#include <algorithm>
#include <cerrno>
#include <exception>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "formats/lines.hpp"

namespace sphereview {

namespace {

constexpr std::size_t read_at_once = std::size_t{1} << 22;
constexpr std::size_t byte_order_mark_size = 3;
constexpr std::size_t longest_head = std::size_t{1} << 18;
constexpr std::uint64_t most_expected_expansion = 32;  // of a packed text

// Where other frames are looked for behind a fault: in so many lines, and so often to the end of the text.
constexpr int most_lines_tried = 100'000;
constexpr int most_attempts = 8;

[[noreturn]] void fail_shorter(const std::string& name) { throw ReadError(name, "it has become shorter meanwhile", EIO); }

}  // namespace

const SceneFormat& format_of_stream(InputStream& stream, const DataOptions& options) {
    stream.fill(std::min(read_at_once, stream.size().value_or(read_at_once) + 1));
    const SceneFormat& format = detect_format(stream.bytes(), stream.name());
    // Only a table has columns: a name that says nothing does not speak against one.
    return !options.columns.empty() && format == SceneFormat::text ? *std::ranges::find_if(scene_formats(), has_columns) : format;
}

FrameReader::FrameReader(const std::string& path, DataOptions options)
    : path_(path), options_(std::move(options)), stream_(path), format_(format_of_stream(stream_, options_)) {
    begin_at_the_beginning();
    if (options_.index_from) note_stamp();
    if (holds_all()) return;
    stream_.remember_places();
    if (stamp_) take_index();
}

FrameReader::~FrameReader() { keep_index(); }

void FrameReader::begin_at_the_beginning() {
    go_to(0);
    stream_.fill(byte_order_mark_size);
    const std::string_view bytes = stream_.bytes();
    end_ = without_byte_order_mark(bytes).size() < bytes.size() ? byte_order_mark_size : 0;
    end_position_ = {};
    of_first_ = 0;
    places_.clear();
    head_of_ = 0;
    head_.clear();
    from_index_ = 0;
    known_end_ = 0;
    found_all_ = false;
    fault_.clear();
    is_damaged_ = false;
    end_marks_.reset();
}

void FrameReader::note_stamp() {
    const std::uint64_t least = stream_.size() ? *options_.index_from : *options_.index_from / most_expected_expansion;
    stamp_ = stamp_of(path_, format_.name);
    if (stamp_ && stamp_->size < least) stamp_.reset();
}

// What was kept of the file, if it still is of this one.
void FrameReader::take_index() {
    std::optional<FrameIndex> index = read_frame_index(*stamp_);
    if (!index) return;
    places_ = std::move(index->frames);
    from_index_ = places_.size();
    known_end_ = end_ = places_.back().end;
    end_position_ = index->end_position;
    of_first_ = index->of_first;
    stream_.remember_places(std::move(index->packed));
    is_a_frame(from_index_ - 1);
}

void FrameReader::keep_index() noexcept {
    if (!stamp_ || places_.size() < 2 || end_ < known_end_ + *options_.index_from || end_ == known_end_) return;
    try {
        FrameIndex index{places_, end_position_, of_first_, GzipPlaces()};
        index.frames.back().end = end_;  // without what stands behind the last frame
        if (stream_.places() != nullptr) index.packed = *stream_.places();
        keep_frame_index(*stamp_, index);
        known_end_ = end_;
    } catch (const std::exception&) {
        // The memory does not suffice: nothing is kept.
    }
}

// Whether the frame of that number, whose place is known, begins and ends there; else nothing counts of the index that says so.
bool FrameReader::is_a_frame(std::size_t number) {
    if (number >= from_index_) return true;
    try {
        const FramePlace& place = places_[number];
        const std::uint64_t end = number + 1 == places_.size() ? end_ : place.end;
        const auto length = static_cast<std::size_t>(end - place.begin);
        PartOfFile part{place.origin, static_cast<std::int64_t>(number), true, place.of_first, head_for(number, place.of_first)};
        go_to(place.begin);
        stream_.fill(length);
        const std::string_view text = text_from(place.begin).substr(0, length);
        if (text.size() == length && format_.step_over(text, true, name(), part) == length) return true;
    } catch (const InputError&) {
        // No frame begins there.
    }
    forget_frame_index(*stamp_);
    stream_.remember_places();
    begin_at_the_beginning();
    return false;
}

std::string_view FrameReader::text_from(std::uint64_t offset) const {
    return stream_.bytes().substr(static_cast<std::size_t>(offset - window_));
}

// The window then begins there, or where it does already when nothing is to be lost.
void FrameReader::go_to(std::uint64_t offset) {
    if (holds_all()) return;
    const auto window_end = [this] { return window_ + stream_.bytes().size(); };
    const std::uint64_t nearest = stream_.nearest_before(offset);
    if (offset < window_ || nearest > window_end()) {
        stream_.go_to(nearest);
        window_ = nearest;
    }
    while (offset > window_end()) {
        window_ = window_end();
        stream_.drop_first(stream_.bytes().size());
        stream_.fill(read_at_once);
        if (stream_.bytes().empty()) fail_shorter(name());
    }
    stream_.drop_first(static_cast<std::size_t>(offset - window_));
    window_ = offset;
}

// What the frame of that number needs of an earlier one, kept here. To be called before go_to().
std::string_view FrameReader::head_for(std::size_t number, std::size_t of_first) {
    const bool has_own = of_first == number + 1;
    if (!format_.has_heads || of_first == 0 || has_own) return {};
    if (head_of_ != of_first) {
        const FramePlace& place = places_.at(of_first - 1);
        const auto length = static_cast<std::size_t>(std::min<std::uint64_t>(place.end - place.begin, longest_head));
        go_to(place.begin);
        stream_.fill(static_cast<std::size_t>(place.begin - window_) + length);
        head_ = text_from(place.begin).substr(0, length);
        head_of_ = of_first;
    }
    return head_;
}

// What is read of the text from end_ on; without the marks of its end, which are looked for once.
std::string_view FrameReader::rest_of_text() {
    std::string_view text = text_from(end_);
    if (!stream_.ended()) return text;
    if (!end_marks_) end_marks_ = text.size() - without_end_marks(text).size();
    text.remove_suffix(std::min(*end_marks_, text.size()));
    return text;
}

// How long the frame at end_ is: 0 where there is none, or a fault, and nothing where what is read of the text does not tell.
std::optional<std::size_t> FrameReader::length_of_next(PartOfFile& part) {
    const std::string_view text = rest_of_text();
    const bool ended = stream_.ended();
    try {
        return format_.step_over(text, ended, name(), part);
    } catch (const InputError& error) {
        if (places_.empty()) throw;
        const auto* fault = dynamic_cast<const TextFault*>(&error);
        const std::optional<bool> lost = fault == nullptr ? true : loses_frames(text, fault->offset, part);
        if (!lost) return std::nullopt;
        is_damaged_ = *lost;
        fault_ = error.what();
        return 0;
    }
}

// Whether frames are lost with the one that is faulty at byte `offset` of `text`; nothing where what is read of the text does not
// tell. Behind an only frame programs write lines of their own, and one that ends with the text is cut off, unless its number of
// atoms is wrong: then there is another frame in what it takes for its own.
std::optional<bool> FrameReader::loses_frames(std::string_view text, std::size_t offset, PartOfFile part) {
    const bool ended = stream_.ended();
    const bool ends_with_text = is_in_last_line(text, offset);
    if (ends_with_text && !ended) return std::nullopt;
    if (!ends_with_text && places_.size() > 1) return true;
    LineWalker lines(text, line_end_of(text), ends_with_text ? 0 : offset);
    for (int head = 0; head < (ends_with_text ? 2 : 1) && !lines.at_end(); ++head) lines.step();
    int attempts = most_attempts;
    for (int line = 0; line < most_lines_tried && !lines.at_end() && attempts > 0; ++line) {
        try {
            const std::optional<std::size_t> length = format_.step_over(text.substr(lines.offset()), ended, name(), part);
            if (!length) return std::nullopt;
            return *length > 0;
        } catch (const TextEnds&) {
            --attempts;
        } catch (const InputError&) {
            // no frame begins here
        }
        lines.step();
    }
    return ended || !lines.at_end() ? std::optional(false) : std::nullopt;
}

// Remembers the place of the next frame; false where there is none.
bool FrameReader::find_next() {
    if (found_all_) return false;
    PartOfFile part{end_position_, static_cast<std::int64_t>(places_.size()), true, of_first_, head_for(places_.size(), of_first_)};
    go_to(end_);
    std::optional<std::size_t> length = length_of_next(part);
    while (!length) {
        stream_.fill(std::max(read_at_once, 2 * stream_.bytes().size()));
        length = length_of_next(part);
    }
    if (*length == 0) {
        found_all_ = true;
        // What stands behind the last frame is read with it: it may be worth a warning.
        if (!places_.empty() && fault_.empty()) places_.back().end = end_ + text_from(end_).size();
        keep_index();
        return false;
    }
    const std::string_view text = text_from(end_);
    places_.push_back({end_, end_ + *length, end_position_, format_.has_heads ? part.of_first : of_first_});
    if (format_.has_heads && part.of_first != of_first_) {  // while it is in the window
        head_ = text.substr(0, std::min(*length, longest_head));
        head_of_ = part.of_first;
    }
    is_whole_ = places_.size() == 1 && stream_.ended() && *length == text.size();
    end_position_ = position_at(text, *length, end_position_);
    end_ += *length;
    of_first_ = part.of_first;
    if (const auto passed = part_passed(); watcher_ && passed) watcher_(*passed);
    return true;
}

// Nothing where nobody knows.
std::optional<double> FrameReader::part_passed() const {
    if (stream_.size()) return static_cast<double>(end_) / static_cast<double>(*stream_.size());
    return stream_.unpacked_part();
}

void FrameReader::count_in_whole_file() {
    stream_.fill();
    if (frames_) return;
    DataOptions first = options_;
    first.frame = 0;
    if (!format_.has_frames) {
        frames_ = 1;
        return;
    }
    SphereData data = format_.read(stream_.bytes(), name(), first);
    frames_ = data.frames;
    fault_ = std::move(data.fault);
    cut_frame_ = data.cut_frame;
}

// A frame behind the last one is looked for from there.
SphereData FrameReader::read_of_whole_file(DataOptions options) {
    const std::int64_t frame = options.frame;
    if (!format_.has_frames) require_frame(name(), frame, 1);
    stream_.fill();
    options.part.stops = true;
    if (behind_last_ > 0 && frame > last_frame_) {
        options.part.frames = last_frame_ + 1;
        options.part.begin = behind_last_;
    }
    SphereData data = format_.read(stream_.bytes(), name(), options);
    last_frame_ = frame;
    behind_last_ = data.next_frame;
    return data;
}

std::int64_t FrameReader::count(std::int64_t enough) {
    if (format_.step_over == nullptr) {
        count_in_whole_file();
        is_damaged_ = is_damaged_ || (cut_frame_ && *cut_frame_ < enough);
        return std::min(*frames_, enough);
    }
    while (static_cast<std::int64_t>(places_.size()) < enough && find_next()) {
    }
    if (places_.empty() && enough > 0) read(0);  // says what is wrong
    return std::min(static_cast<std::int64_t>(places_.size()), enough);
}

SphereData FrameReader::read(std::int64_t frame) {
    DataOptions options = options_;
    options.frame = frame;
    if (format_.step_over == nullptr) {
        return read_of_whole_file(options);
    }
    while (static_cast<std::int64_t>(places_.size()) <= frame && find_next()) {
    }
    const auto known = static_cast<std::int64_t>(places_.size());
    if (known == 0 || (known == 1 && is_whole_)) {
        go_to(known == 0 ? end_ : places_[0].begin);
        stream_.fill();
        return format_.read(stream_.bytes(), name(), options);
    }
    if (frame >= known && !fault_.empty()) throw InputError(fault_);
    require_frame(name(), frame, known);
    if (!is_a_frame(static_cast<std::size_t>(frame))) return read(frame);
    const FramePlace& place = places_[static_cast<std::size_t>(frame)];
    const std::string_view head = head_for(static_cast<std::size_t>(frame), place.of_first);
    go_to(place.begin);
    const auto length = static_cast<std::size_t>(place.end - place.begin);
    stream_.fill(static_cast<std::size_t>(place.end - window_));
    if (text_from(place.begin).size() < length) fail_shorter(name());
    options.part = {place.origin, frame, true, place.of_first, head};
    return format_.read(text_from(place.begin).substr(0, length), name(), options);
}

}  // namespace sphereview

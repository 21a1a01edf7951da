#include "formats/frame_reader.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

constexpr std::size_t read_at_once = std::size_t{1} << 22;
constexpr std::size_t byte_order_mark_size = 3;

// By what a file begins with, as for a single scene (app/load_scene.cpp).
SceneFormat format_of(InputStream& stream, const DataOptions& options) {
    stream.fill(std::min(read_at_once, stream.size().value_or(read_at_once) + 1));
    const SceneFormat& format = detect_format(stream.bytes(), stream.name());
    return !options.columns.empty() && format == SceneFormat::text ? *find_format("CSV") : format;
}

}  // namespace

FrameReader::FrameReader(const std::string& path, DataOptions options)
    : path_(path), options_(std::move(options)), stream_(path), format_(format_of(stream_, options_)) {
    const std::string_view bytes = stream_.bytes();
    if (without_byte_order_mark(bytes).size() < bytes.size()) end_ = byte_order_mark_size;
}

std::string_view FrameReader::text_from(std::uint64_t offset) const {
    return stream_.bytes().substr(static_cast<std::size_t>(offset - window_));
}

// The window then begins there, or where it does already when nothing is to be lost.
void FrameReader::go_to(std::uint64_t offset) {
    if (holds_all()) return;
    if (offset < window_ || (offset > window_ + stream_.bytes().size() && stream_.size())) {
        if (stream_.size()) {
            stream_.go_to(offset);
            window_ = offset;
            return;
        }
        stream_ = InputStream(path_);
        window_ = 0;
    }
    while (offset > window_ + stream_.bytes().size()) {
        window_ += stream_.bytes().size();
        stream_.drop_first(stream_.bytes().size());
        stream_.fill(read_at_once);
        if (stream_.bytes().empty()) throw InputError(name() + ": has become shorter while it was read");
    }
    stream_.drop_first(static_cast<std::size_t>(offset - window_));
    window_ = offset;
}

// Remembers the place of the next frame; false where there is none.
bool FrameReader::find_next() {
    if (found_all_) return false;
    PartOfFile part{end_position_, static_cast<std::int64_t>(places_.size()), true, numbers_behind_first_};
    go_to(end_);
    std::optional<std::size_t> length;
    while (true) {
        const std::string_view text = text_from(end_);
        const bool ended = stream_.ended();
        try {
            length = format_.step_over(text, ended, name(), part);
        } catch (const InputError& error) {
            if (places_.empty()) throw;
            fault_ = error.what();
            length = 0;
        }
        if (length) break;
        stream_.fill(std::max(read_at_once, 2 * stream_.bytes().size()));
    }
    if (*length == 0) {
        found_all_ = true;
        // What stands behind the last frame is read with it: it may be worth a warning.
        if (!places_.empty() && fault_.empty()) places_.back().end = end_ + text_from(end_).size();
        return false;
    }
    const std::string_view text = text_from(end_);
    places_.push_back({end_, end_ + *length, end_position_, numbers_behind_first_});
    is_whole_ = places_.size() == 1 && stream_.ended() && *length == text.size();
    end_position_ = position_at(text, *length, end_position_);
    end_ += *length;
    numbers_behind_first_ = part.numbers_behind_first;
    if (watcher_ && stream_.size() && *stream_.size() > 0) {
        watcher_(static_cast<double>(end_) / static_cast<double>(*stream_.size()));
    }
    return true;
}

void FrameReader::count_in_whole_file() {
    stream_.fill();
    if (frames_) return;
    DataOptions first = options_;
    first.frame = 0;
    frames_ = format_.has_frames ? format_.read(stream_.bytes(), name(), first).frames : 1;
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
    const Place& place = places_[static_cast<std::size_t>(frame)];
    go_to(place.begin);
    const auto length = static_cast<std::size_t>(place.end - place.begin);
    stream_.fill(static_cast<std::size_t>(place.end - window_));
    if (text_from(place.begin).size() < length) throw InputError(name() + ": has become shorter while it was read");
    options.part = {place.origin, frame, true, place.numbers_behind_first};
    return format_.read(text_from(place.begin).substr(0, length), name(), options);
}

}  // namespace sphereview

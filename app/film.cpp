#include "app/film.hpp"

#include <cerrno>
#include <filesystem>
#include <mutex>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

#include "base/background_job.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/interrupt.hpp"
#include "base/path.hpp"
#include "base/standard_streams.hpp"
#include "base/text.hpp"
#include "formats/lines.hpp"

namespace sphereview {

namespace {

using Words = std::vector<std::string>;

std::string as_text(FrameRate rate) { return std::to_string(rate.pictures) + "/" + std::to_string(rate.seconds); }

void append(Words& words, const Words& more) { words.insert(words.end(), more.begin(), more.end()); }

Words encoding(const FilmKind& kind, int quality, bool alpha) {
    Words words = {"-c:v", std::string(kind.encoder)};
    if (kind.has_quality()) {
        append(words, {"-crf", std::to_string(kind.worst - (kind.range * quality + 40) / best_film_quality)});
        // BT.709, as image/y4m.hpp has it, with half the colour's pixels along each side, which every player shows; sides become
        // even.
        append(words, {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
                       "-colorspace", "bt709", "-color_range", "tv", "-color_trc", "bt709", "-color_primaries", "bt709"});
    }
    if (kind.has_alpha()) append(words, {"-pix_fmt", std::string(kind.pixels[alpha ? 1 : 0])});
    for (const std::string_view word : words_of(kind.words, " ")) words.emplace_back(word);
    return words;
}

}  // namespace

std::string find_film_encoder() { return find_program("ffmpeg"); }

FilmEncoder ask_film_encoder(std::chrono::milliseconds limit) {
    FilmEncoder encoder{find_film_encoder()};
    if (encoder.program.empty()) {
        encoder.fault = "no program ffmpeg in the folders of PATH";
        return encoder;
    }
    ProgramResult answer;
    try {
        answer = run_program(encoder.program, {"-hide_banner", "-encoders"}, limit);
    } catch (const OutputError& error) {
        encoder.fault = error.what();
        return encoder;
    }
    for (const FilmKind& kind : film_kinds()) {
        if (answer.output.find(" " + std::string(kind.encoder) + " ") != std::string::npos) {
            encoder.endings.emplace_back(kind.ending);
        } else {
            encoder.lacks.push_back(std::string(kind.ending) + " (" + std::string(kind.encoder) + ")");
        }
    }
    if (answer.end != ProgramResult::End::returned || encoder.endings.empty()) {
        encoder.endings.clear();
        encoder.fault = encoder.program + " does not say which encoders it has";
    }
    return encoder;
}

Film::Film(const FilmOptions& options, Durability durability, std::size_t pictures)
    : options_(options), durability_(durability), pictures_(pictures) {
    if (!options.movie) return;
    program_ = find_film_encoder();
    if (program_.empty()) {
        throw RenderError(
            "--movie: found no program ffmpeg in the folders of PATH, which makes films; expected it, or -o - for another encoder");
    }
}

Film::~Film() {
    const std::lock_guard lock(mutex_);
    encoder_.reset();  // before its file goes
    place_.reset();
}

std::string Film::how_far() const {
    return *options_.movie + ": not written; " + in_groups(added_) + " of " + in_groups(pictures_) + " pictures were done";
}

std::unique_lock<std::mutex> Film::give_up() {
    std::unique_lock lock(mutex_);
    const bool too_late = begun_ && !place_;
    if (too_late) return {};
    given_up_ = true;
    if (encoder_) encoder_->kill();
    place_.reset();
    return lock;
}

void Film::begin() {
    if (!options_.movie) return;
    const std::lock_guard lock(mutex_);
    if (given_up_) throw Cancelled();
    place_ = std::make_unique<OutputPlace>(*options_.movie);
    begun_ = true;
}

void Film::start(const Image& first) {
    const bool alpha = first.channels() == 4;
    if (alpha && !(options_.movie && film_kind(*options_.movie)->has_alpha())) {
        throw InputError(options_.movie.value_or("stdout") +
                         ": found a transparent background, which such a film cannot have; expected another --background");
    }
    if (!options_.movie) {
        write_output(std::string(standard_stream), y4m_head(first.width(), first.height(), options_.rate));
        return;
    }
    Words words = {"-hide_banner",
                   "-loglevel",
                   "error",
                   "-f",
                   "rawvideo",
                   "-pix_fmt",
                   alpha ? "rgba" : "rgb24",
                   "-video_size",
                   std::to_string(first.width()) + "x" + std::to_string(first.height()),
                   "-framerate",
                   as_text(options_.rate),
                   "-i",
                   "pipe:0",
                   "-an",
                   "-bitexact"};
    append(words, encoding(*film_kind(*options_.movie), options_.quality.value_or(usual_film_quality), alpha));
    // Who gives up meanwhile waits until there is an encoder to end: it would leave its file behind.
    const std::lock_guard lock(mutex_);
    if (given_up_) throw Cancelled();
    const std::string& file = place_->temporary();
    // Written as a path: ffmpeg takes a word before a colon for a protocol.
    append(words, {"-y", path_from(file).is_absolute() ? file : "./" + file});
    encoder_ = std::make_unique<PipedProgram>(program_, words);
}

void Film::fail() {
    { const std::lock_guard lock(mutex_); }  // an interruption that has ended the encoder ends this process as well
    encoder_->finish();
    std::string_view errors = encoder_->errors();
    Words lines;
    while (!errors.empty()) {
        const std::string_view line = trimmed(take_line(errors));
        if (!line.empty()) lines.emplace_back(line);
    }
    const ProgramResult& result = encoder_->result();
    const bool crashed = result.end == ProgramResult::End::crashed;
    const std::string end = crashed ? "ffmpeg was ended by signal " + std::to_string(result.code) : "ffmpeg has failed";
    const std::string why = on_one_line(joined(lines, "; "));
    throw OutputError(*options_.movie, end + (why.empty() ? "" : ": " + why), EIO);
}

void Film::add(const Image& picture) {
    if (added_ == 0) start(picture);
    if (encoder_) {
        const auto bytes = picture.bytes();
        if (!encoder_->write({reinterpret_cast<const char*>(bytes.data()), bytes.size()})) fail();
    } else {
        write_output(std::string(standard_stream), y4m_frame(picture));
    }
    const std::lock_guard lock(mutex_);
    ++added_;
}

void Film::finish() {
    if (encoder_) {
        std::error_code unknown;
        bool is_film = encoder_->finish();
        std::optional<Unfinished> unfinished;
        std::unique_ptr<OutputPlace> taken;
        {
            const std::lock_guard lock(mutex_);
            if (given_up_) throw Cancelled();
            is_film = is_film && std::filesystem::file_size(path_from(place_->temporary()), unknown) > 0;
            if (is_film) {
                unfinished.emplace();  // only behind the lock: an interruption that holds it waits for what is unfinished
                taken = std::move(place_);
            }
        }
        if (!is_film) fail();
        taken->take(durability_);  // without the lock: a disk may take long
    }
    finished_ = true;
}

InterruptibleFilm::InterruptibleFilm(Film& film) : film_(film) {
    interruptible_.emplace([this] {
        given_up_ = film_.give_up();
        return given_up_ ? film_.how_far() : "";
    });
    film_.begin();
}

InterruptibleFilm::~InterruptibleFilm() {
    interruptible_.reset();  // from now on there is nothing to say twice
    if (film_.is_finished()) return;
    try {
        say(film_.how_far());
    } catch (const std::bad_alloc&) {
        // The end of the command reports that memory ran out.
    }
}

}  // namespace sphereview

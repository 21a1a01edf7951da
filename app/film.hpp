// Makes one film of several pictures.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/film_options.hpp"
#include "app/interruptible.hpp"
#include "base/output_file.hpp"
#include "base/program.hpp"
#include "image/image.hpp"
#include "scene/camera.hpp"

namespace sphereview {

// The path of ffmpeg, found in PATH; "" where there is none.
std::string find_film_encoder();

// Which films ffmpeg can make here.
struct FilmEncoder {
    std::string program{};
    std::vector<std::string> endings{};  // of the films that it makes
    std::vector<std::string> lacks{};    // ".mp4 (libx264)": other endings and the missing encoder
    std::string fault{};                 // why it makes no film; else ""
};
FilmEncoder ask_film_encoder(std::chrono::milliseconds limit);

class Film {
public:
    // Writes to the options' file by ffmpeg, under a hidden name until finish(); without a file, uncompressed to standard output
    // (image/y4m.hpp). `pictures`: how many there will be, for messages. Throws RenderError where there is no ffmpeg.
    Film(const FilmOptions& options, Durability durability, std::size_t pictures);
    // Removes an unfinished film.
    ~Film();
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    // Each throws OutputError, and Cancelled after give_up(). begin() makes the file; the other thread must be able to call
    // give_up() by then.
    void begin();
    void add(const Image& picture);
    void finish();

    // Whether the film goes to standard output.
    bool is_streamed() const { return !options_.movie; }
    // For the thread that adds pictures.
    bool is_finished() const { return finished_; }
    // "out.mp4: not written; 3 of 10 pictures were done". Call from the thread that adds pictures, or after give_up().
    std::string how_far() const;
    // From another thread: ends the encoder and removes the film. The thread that adds pictures waits while the returned lock is
    // held. The lock is not held if it is too late: the film has its name, or is getting it.
    [[nodiscard]] std::unique_lock<std::mutex> give_up();

private:
    void start(const Image& first);
    [[noreturn]] void fail();

    FilmOptions options_;
    Durability durability_;
    std::size_t pictures_;
    std::size_t added_ = 0;
    std::string program_{};  // ffmpeg
    std::unique_ptr<OutputPlace> place_{};
    std::unique_ptr<PipedProgram> encoder_{};
    bool finished_ = false;
    bool begun_ = false;
    bool given_up_ = false;
    std::mutex mutex_{};  // held where another thread may give up
};

// While this lives, an interruption removes the film of a command and says how many pictures were done; so does the destructor, if
// the film is not finished. One at a time.
class InterruptibleFilm {
public:
    // Begins the film. Throws as Film::begin().
    explicit InterruptibleFilm(Film& film);
    ~InterruptibleFilm();
    InterruptibleFilm(const InterruptibleFilm&) = delete;
    InterruptibleFilm& operator=(const InterruptibleFilm&) = delete;

private:
    Film& film_;
    std::unique_lock<std::mutex> given_up_{};
    std::optional<Interruptible> interruptible_{};
};

}  // namespace sphereview

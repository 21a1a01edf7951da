// Pictures that become one film.
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

// The program that makes films, as a shell would find it; "" where there is none.
std::string find_film_encoder();

// What that program says of itself.
struct FilmEncoder {
    std::string program{};
    std::vector<std::string> endings{};  // of the films that it makes
    std::vector<std::string> lacks{};    // ".mp4 (libx264)": the endings of others, and the encoder that they need
    std::string fault{};                 // why it makes none
};
FilmEncoder ask_film_encoder(std::chrono::milliseconds limit);

class Film {
public:
    // On standard output, uncompressed (image/y4m.hpp), or, where the options name a file, by ffmpeg, beside the file until
    // finish(). `pictures`: how many there will be, for messages. Throws RenderError where there is no ffmpeg, and OutputError.
    Film(const FilmOptions& options, Durability durability, std::size_t pictures);
    // Leaves nothing of a film that is not finished.
    ~Film();
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    // Each throws OutputError, and Cancelled where the film was given up.
    void add(const Image& picture);
    void finish();

    // Whether it goes to standard output.
    bool is_streamed() const { return !options_.movie; }
    // For the thread that adds pictures.
    bool is_finished() const { return finished_; }
    // "out.mp4: not written; 3 of 10 pictures were done". For the thread that adds pictures, or who has given up the film.
    std::string how_far() const;
    // From another thread: ends the encoder and leaves nothing of the film. The thread that adds pictures waits for as long as what
    // is returned lives. That holds no lock where it is too late: the film gets its name just now, or has it.
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
    std::mutex mutex_{};  // held where another thread may give up
};

// A film that a command makes, while this lives: an interruption leaves nothing of it, and says how many pictures were done, as
// does the end of this where the film is not finished. One at a time.
class InterruptibleFilm {
public:
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

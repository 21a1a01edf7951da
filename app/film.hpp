// Pictures that become one film.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "app/film_options.hpp"
#include "base/output_file.hpp"
#include "base/piped_program.hpp"
#include "image/image.hpp"
#include "scene/camera.hpp"

namespace sphereview {

// The program that makes films, as a shell would find it; "" where there is none.
std::string find_film_encoder();

class Film {
public:
    // On standard output, uncompressed (image/y4m.hpp), or, where the options name a file, by ffmpeg, beside the file until
    // finish(). `pictures`: how many there will be, for messages. An interruption from now on says how many were done. Throws
    // RenderError where there is no ffmpeg, and OutputError.
    Film(const FilmOptions& options, Durability durability, std::size_t pictures);
    // Leaves nothing of a film that is not finished, and says how many pictures it had.
    ~Film();
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    // Throws OutputError.
    void add(const Image& picture);
    void finish();

private:
    void start(const Image& first);
    [[noreturn]] void fail();
    std::string how_far() const;

    static void interrupt(int signal_number);

    FilmOptions options_;
    Durability durability_;
    std::size_t pictures_;
    std::size_t added_ = 0;
    std::string program_{};  // ffmpeg
    std::unique_ptr<OutputPlace> place_{};
    std::unique_ptr<PipedProgram> encoder_{};
    bool finished_ = false;
};

}  // namespace sphereview

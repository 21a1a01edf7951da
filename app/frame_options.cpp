#include "app/frame_options.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/add_option.hpp"
#include "base/input_file.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

constexpr const char* fit_first = "--fit-first";

// For renders that are spread over machines, or go on after an end.
void add_farm_options(CLI::App& command, RenderOptions& options) {
    FrameOptions& frames = options.frames;
    add_flag(command, frames.skip_existing, "--skip-existing",
             "Leave pictures alone that are there whole, of the size that is asked for: goes on where a run was ended");
    add_option(command, frames.part,
               {"--part", "K/N", "Only every N-th picture, from the K-th on: for N machines or processes", "K/N, such as 1/4"},
               [](const std::string& text) { return parse_part_of_pictures(text); });
    add_file(command, frames.manifest, "--manifest", "FILE",
             "A JSON line for each picture: its SHA-256 and what it was made of, for 'sphereview verify'");
}

void add_film_options(CLI::App& command, FilmOptions& film) {
    const std::string endings = "a name that ends with " + film_endings("or");
    CLI::Option* movie =
        add_option(command, film.movie,
                   {"--movie", "FILE",
                    "A film of the pictures, by the program ffmpeg: " + endings + ", which alone decides the format", endings},
                   [](const std::string& text) { return film_kind(text) != nullptr ? std::optional(text) : std::nullopt; });
    const char* rate = "a whole number or a fraction such as 30000/1001";
    add_option(command, film.rate, {"--fps", "RATE", "Pictures a second of a film [30]", rate},
               [](const std::string& text) { return parse_frame_rate(text); });
    const std::string quality = "1 to " + std::to_string(best_film_quality);
    add_option(command, film.quality,
               {"--quality", "Q",
                "Of " + film_endings("and", true) + ", " + quality + " [" + std::to_string(usual_film_quality) +
                    "]; .mkv and .png lose nothing",
                "a whole number from " + quality},
               [](const std::string& text) {
                   const auto number = whole_number(text, 1);
                   return number && *number <= best_film_quality ? number : std::nullopt;
               })
        ->needs(movie);
}

// The name under which a manifest has it; "" of what says how pictures are made, where they go, or what is said of them.
std::string name_in_pictures(const CLI::Option& option) {
    constexpr auto others = std::to_array<std::string_view>(
        {"--help", "--output", "--backend", "--device", "--expect", "--diff", "--no-sync", "--timings", "--json", "--verbose",
         "--skip-existing", "--part", "--manifest", "--movie", "--fps", "--quality", "--no-index"});
    if (option.get_lnames().empty()) return "";
    const std::string name = "--" + option.get_lnames().front();
    return std::ranges::find(others, name) == others.end() ? name : "";
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

// What a film cannot be.
void check_film_options(const CLI::App& command, const RenderOptions& options) {
    const FrameOptions& frames = options.frames;
    if (!options.film.movie && !options.streams_film()) {
        if (find_option(command, "--fps")->count() > 0) wrong("--fps", "no film", "--movie, or -o - with several frames");
        return;
    }
    if (options.film.movie && options.streams_film()) wrong("--movie", "--output -", "one of the two films");
    const std::string option = options.film.movie ? "--movie" : "--output";
    if (!frames.several()) throw CLI::ValidationError("--movie needs --frames or --turntable");
    if (options.scenes.size() != 1) wrong(option, std::to_string(options.scenes.size()) + " scenes", "one for a film");
    if (frames.part) wrong(option, "--part", "all pictures of a film");
    if (frames.skip_existing) wrong(option, "--skip-existing", "all pictures of a film");
    if (!options.film.movie) return;
    const FilmKind& kind = *film_kind(*options.film.movie);
    if (const std::string rates = rates_instead_of(options.film.rate, kind); !rates.empty()) {
        wrong("--fps", find_option(command, "--fps")->results().front(), rates);
    }
    if (options.film.quality && !kind.has_quality()) {
        wrong("--quality", in_quotes(*options.film.movie),
              "a name that ends with " + film_endings("or", true) + ": others have no quality to choose");
    }
}

}  // namespace

void add_frame_options(CLI::App& command, RenderOptions& options) {
    FrameOptions& frames = options.frames;
    CLI::Option* list = add_option(
        command, frames.ranges,
        {"--frames", "LIST",
         "Pictures of several frames, named by {frame}: " + std::string(frames_syntax) +
             "; B is the first that is left out. One camera for all, fitted to all that they hold, or with --fit first to the "
             "first of them",
         frames_syntax},
        [](const std::string& text) { return parse_frames(text); });
    list->excludes(find_option(command, "--frame"));
    add_file(command, options.fit.camera, "--camera", "SCENE",
             "See everything by the camera of this TOML scene, or by the view of it that --view names");
    CLI::Option* first = add_flag(command, frames.fit_first, fit_first, "");
    first->group("");  // written as --fit first
    CLI::Option* turntable =
        add_option(command, frames.turntable,
                   {"--turntable", "N", "N pictures once around; with --frames the view turns 1/N of that from frame to frame",
                    "the number of pictures of a turn, from 1 to 1000000"},
                   [](const std::string& text) -> std::optional<std::int64_t> {
                       constexpr std::int64_t most = 1'000'000;  // each takes memory
                       const auto number = whole_number<std::int64_t>(text, 1);
                       return number && *number <= most ? number : std::nullopt;
                   });
    const std::string axes = listed(std::vector<std::string>(turn_axis_names.begin(), turn_axis_names.end()), "or");
    add_option(command, frames.axis,
               {"--axis", "AXIS", "What --turntable turns about: " + axes + " [up, the view's own upward direction]", axes},
               [](const std::string& text) { return turn_axis_named(text); })
        ->needs(turntable);
    add_farm_options(command, options);
    add_film_options(command, options.film);
}

std::vector<std::string> picture_words(const CLI::App& command) {
    std::vector<std::string> words;
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = name_in_pictures(*option);
        if (option->count() == 0 || name.empty()) continue;
        words.push_back(name);
        if (takes_value(*option)) words.push_back(option->results().front());
    }
    return words;
}

void require_picture_words(const CLI::App& command, const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const CLI::Option* option = find_option(command, words[i]);
        if (option == nullptr || name_in_pictures(*option) != words[i]) {
            throw CLI::ValidationError(found_expected(words[i], "options that say what a picture looks like"));
        }
        if (takes_value(*option)) ++i;
    }
}

void check_frame_options(const CLI::App& command, const RenderOptions& options) {
    check_film_options(command, options);
    const FrameOptions& frames = options.frames;
    if (frames.fit_first && command.get_option("--no-fit")->count() > 0) wrong("--fit", "'first'", "no --no-fit beside it");
    if (frames.fit_first && frames.ranges.empty()) wrong("--fit", "'first'", "--frames, of which that is the first");
    if (options.fit.camera && (options.fit.wanted.value_or(false) || frames.fit_first)) {
        wrong("--camera", in_quotes(*options.fit.camera), "no --fit and no --view from a side beside it: they move the camera");
    }
    if (frames.manifest == std::string(standard_stream))
        wrong("--manifest", "'-'", "a file: --json writes lines to standard output");
    if (frames.skip_existing && options.expect)
        wrong("--skip-existing", "--expect", "one of the two: what is skipped is not compared");
}

void join_fit_first(std::vector<std::string>& words) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (words[i] == "--") return;
        if (words[i] != "--fit" || words[i + 1] != "first") continue;
        words[i] = fit_first;
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
}

}  // namespace sphereview

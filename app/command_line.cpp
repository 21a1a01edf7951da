#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <new>

#include "app/add_option.hpp"
#include "app/command_line_texts.hpp"
#include "app/failure.hpp"
#include "app/frame_options.hpp"
#include "app/licenses.hpp"
#include "app/look_options.hpp"
#include "app/options.hpp"
#include "app/render_picture.hpp"
#include "app/shared_options.hpp"
#include "app/usage_error.hpp"
#include "app/version.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/path.hpp"
#include "base/text.hpp"
#include "scene/camera.hpp"

namespace sphereview {

namespace {

const std::string program_and_version = "sphereview " + std::string(version);

std::string backends_listed() { return listed(std::vector<std::string>(backend_names.begin(), backend_names.end()), "or"); }

std::optional<Backend> backend_named(const std::string& name) {
    const auto found = std::ranges::find(backend_names, name);
    return found == backend_names.end() ? std::nullopt : std::optional(static_cast<Backend>(found - backend_names.begin()));
}

// While one lives, the program ends where memory runs out: CLI11 allocates in functions that are noexcept.
class EndsWithoutMemory {
public:
    EndsWithoutMemory() : before_(std::set_new_handler(end_without_memory)) {}
    ~EndsWithoutMemory() { std::set_new_handler(before_); }
    EndsWithoutMemory(const EndsWithoutMemory&) = delete;
    EndsWithoutMemory& operator=(const EndsWithoutMemory&) = delete;

private:
    std::new_handler before_;
};

// Of each command: its options, and a check of what they are together, which throws CLI::ParseError.

template <typename Options>
void check(const CLI::App&, const Options&) {}  // where each option stands for itself

void declare(CLI::App& command, ViewOptions& options) {
    add_file(command, options.scene, "SCENE", "", scene_files() + "; none: an empty scene");
    add_scene_options(command, options.data, options.fit);
    add_look(command, options.look);
    add_size(command, options.size, "Width and height of exports in pixels [as last time, at first 1000x1000]");
    add_samples(command, options.samples,
                "Anti-aliasing of exports and of the window at rest: points a pixel, 1, 4 or 16 [as last time, at first 16]");
    add_colors(command, options.background, options.shading, "as last time, at first studio");
    add_light(command, options.light);
    add_option(command, options.shader_folder,
               {"--shader-dir", "FOLDER", "Use the shaders in this folder, and each that is saved there at once", a_folder},
               [](const std::string& text) {
                   std::error_code ignored;
                   return std::filesystem::is_directory(path_from(text), ignored) ? std::optional(text) : std::nullopt;
               });
    add_file(command, options.redraw_log, "--redraw-log", "FILE", "")->group("");  // hidden: for tests
    options.program = {program_and_version, licenses};
    command.footer(std::string(view_examples) + exit_codes);
}

void check(const CLI::App&, const ViewOptions& options) {
    check_light(options.light, options.shading.value_or(Shading::studio));
    check_look(options.look);
}

void declare(CLI::App& command, RenderOptions& options) {
    add_files(command, options.scenes, "SCENE", scene_files());
    add_file(command, options.output, "-o,--output", "FILE", "PNG file, or a pattern with {name}; - is standard output");
    add_size(command, options.size, "Width and height in pixels [1000x1000]");
    add_samples(command, options.samples, "Anti-aliasing: points a pixel, whose colours are averaged: 1, 4 or 16 [1]");
    add_scene_options(command, options.data, options.fit);
    add_look(command, options.look);
    add_frame_options(command, options);
    add_colors(command, options.background, options.shading, "flat");
    add_light(command, options.light);
    add_flag(command, options.axes, "--axes", "Draw the directions of the axes in the lower left corner");
    add_flag(command, options.scale_bar, "--scale-bar",
             "Draw the length of a number of the scene's units in the lower right corner; in perspective as it is as deep as the "
             "scene's middle");
    add_flag(command, options.legend, "--legend", "Draw what the colours stand for in the upper right corner, with --color-by")
        ->needs(find_option(command, "--color-by"));
    add_option(command, options.backend,
               {"--backend", "NAME", backends_listed() + " [auto, or SPHEREVIEW_BACKEND]", backends_listed()}, backend_named);
    add_option(command, options.device,
               {"--device", "N", "Number of an EGL device, as 'doctor' lists them",
                "the number of an EGL device, as 'sphereview doctor' lists them"},
               [](const std::string& text) { return whole_number(text, 0); });
    CLI::Option* expect =
        add_file(command, options.expect, "--expect", "GOLDEN", "Compare with this PNG ({name} with several scenes)");
    add_file(command, options.diff, "--diff", "FILE", "With --expect: write a picture of the difference")->needs(expect);
    add_flag(command, options.certify, "--no-certify",
             "For comparison: keep float's best guess where float cannot tell which sphere is seen. What is lost: the "
             "picture may differ by a few pixels from one machine to the next",
             false);
    add_flag(command, options.durability, "--no-sync",
             "Do not wait until the disk has each picture, some milliseconds: for many of them. A power cut may lose the last ones",
             Durability::in_system);
    add_flag(command, options.timings, "--timings", "Say on stderr how long each phase took, in ms");
    add_flag(command, options.json, "--json", "Report each scene as one JSON line on stdout");
    add_flag(command, options.verbose, "--verbose",
             "Say on stderr which backend is used and why, in which tiles the spheres are, and how the pixels were decided");
    command.footer(std::string(render_examples) + exit_codes);
}

void check(const CLI::App& command, RenderOptions& options) {
    check_frame_options(command, options);
    options.words = picture_words(command);
    check_light(options.light, options.shading);
    check_look(options.look);
    const int longest = longest_side(options.samples);
    if (std::max(options.size.width, options.size.height) > longest) {
        wrong("--size", in_quotes(std::to_string(options.size.width) + "x" + std::to_string(options.size.height)),
              "sides of at most " + std::to_string(longest) + " pixels with --samples " + std::to_string(options.samples));
    }
    const bool named = find_option(command, "--backend")->count() > 0;
    const char* variable = std::getenv("SPHEREVIEW_BACKEND");
    if (!named && variable != nullptr && *variable != '\0') {
        const std::optional<Backend> backend = backend_named(variable);
        if (!backend) wrong("SPHEREVIEW_BACKEND", in_quotes(variable), backends_listed());
        options.backend = *backend;
    }
    if (!options.device) return;
    if (named && options.backend != Backend::automatic && options.backend != Backend::egl) {
        wrong("--backend", in_quotes(name_of(options.backend)), "egl with --device, which picks an EGL device");
    }
    options.backend = Backend::egl;  // a device named on the command line counts more than the environment
}

void declare(CLI::App& command, ConvertOptions& options) {
    add_file(command, options.input, "IN", "", scene_files())->required();
    add_file(command, options.output, "OUT", "", "Scene file, whose ending tells its format; - is standard output")->required();
    const std::string formats = lower_case(listed(format_names(is_written), "or"));
    add_option(command, options.to, {"--to", "FORMAT", formats + ", whatever OUT is called", formats},
               [](const std::string& text) -> std::optional<SceneFormat> {
                   const SceneFormat* format = find_format(text);
                   return format != nullptr && is_written(*format) ? std::optional(*format) : std::nullopt;
               });
    add_scene_options(command, options.data, options.fit);
    add_properties(command, options.data);
    add_look(command, options.look);
    add_flag(command, options.verbose, "--verbose", "Say on stderr what was read, and what of it was passed over");
    command.footer(std::string(convert_examples) + exit_codes);
}

void check(const CLI::App&, const ConvertOptions& options) {
    check_look(options.look);
    if (options.output == standard_stream && !options.to) {
        throw CLI::ValidationError("OUT", "standard output has no name to tell the format; add --to FORMAT: " +
                                              lower_case(listed(format_names(is_written), "or")));
    }
}

void declare(CLI::App& command, ExplainOptions& options) {
    add_file(command, options.scene, "SCENE", "", scene_files())->required();
    add_option(command, options.pixel,
               {"-p,--pixel", "X,Y", "Column from the left and row from the top, from 0", "X,Y, such as 500,500"},
               [](const std::string& text) -> std::optional<Pixel> {
                   const auto place = whole_numbers(text, ",", std::numeric_limits<int>::min());
                   return place ? std::optional(Pixel{place->first, place->second}) : std::nullopt;
               })
        ->required();
    add_size(command, options.size, "Width and height of the picture in pixels [1000x1000]");
    add_scene_options(command, options.data, options.fit);
    add_properties(command, options.data);
    add_look(command, options.look);
    add_colors(command, options.background, options.shading, "flat");
    add_light(command, options.light);
    add_option(command, options.light_to_show,
               {"--light", "K",
                "Explain one of the lights: 0 is the sun, and the sky's begin at 1 [the sun, or the nearest to the key light]",
                "the number of a light, from 0"},
               [](const std::string& text) { return whole_number(text, 0); });
    add_flag(command, options.json, "--json", "The same as one JSON line");
    command.footer(std::string(explain_examples) + exit_codes);
}

void check(const CLI::App&, const ExplainOptions& options) {
    check_light(options.light, options.shading);
    check_look(options.look);
    if (options.light_to_show) check_shows_light("--light", options.shading);
    const auto& [pixel, size] = std::pair(options.pixel, options.size);
    if (pixel.x >= 0 && pixel.y >= 0 && pixel.x < size.width && pixel.y < size.height) return;
    wrong("--pixel", in_quotes(std::to_string(pixel.x) + "," + std::to_string(pixel.y)),
          "a pixel from 0,0 to " + std::to_string(size.width - 1) + "," + std::to_string(size.height - 1));
}

void declare(CLI::App& command, CompareOptions& options) {
    add_files(command, options.pictures, "PICTURE", "Pictures, and last the scene: " + scene_files())->type_name("... SCENE");
    add_scene_options(command, options.data, options.fit);
    add_look(command, options.look);
    const std::string colors(background_syntax);
    add_option(command, options.background, {"--background", "COLOR", "Instead of the scene's: " + colors, colors},
               background_named);
    CLI::Option* difference =
        add_file(command, options.difference, "--diff", "FILE",
                 "Where the picture of the difference goes, {name} is the picture's and {folder} its folder's "
                 "[{name}-difference.png]");
    add_flag(command, options.writes_difference, "--no-diff", "Write no picture of the difference", false)->excludes(difference);
    add_flag(command, options.json, "--json", "Report each picture as one JSON line");
    command.footer(std::string(compare_examples) + exit_codes);
}

void check(const CLI::App&, CompareOptions& options) {
    check_look(options.look);
    if (options.pictures.size() < 2) wrong("PICTURE", "one file alone", "pictures, and last the scene");
    options.scene = options.pictures.back();
    options.pictures.pop_back();
    const auto from_stdin = std::ranges::count(options.pictures, standard_stream) + (options.scene == standard_stream ? 1 : 0);
    if (from_stdin > 1) wrong("PICTURE", "'-' twice", "standard input once");
    if (options.difference == standard_stream) wrong("--diff", "'-'", "a file: standard output has the report");
}

// The options of `render` by the words of a manifest; messages begin with `where` they stand.
RenderOptions parse_render(const std::string& scene, const std::vector<std::string>& words, const std::string& where) {
    const EndsWithoutMemory ends_without_memory;
    CLI::App app("", "sphereview");
    app.allow_windows_style_options(false);
    RenderOptions options;
    declare(app, options);
    std::vector<std::string> reversed{scene, "--"};
    reversed.insert(reversed.end(), words.rbegin(), words.rend());
    try {
        require_picture_words(app, words);
        app.parse(reversed);
        check(app, options);
    } catch (const CLI::ParseError& error) {
        throw InputError(where + in_words(app, error));
    }
    return options;
}

void declare(CLI::App& command, VerifyOptions& options) {
    add_files(command, options.manifests, "MANIFEST", "What render --manifest has written; of several parts all at once");
    const char* size = "a part such as 1%, or a number of pictures";
    add_option(command, options.sample, {"--sample", "N", std::string("How many are rendered again: ") + size + " [100%]", size},
               [](const std::string& text) -> std::optional<SampleSize> {
                   const bool is_percent = text.ends_with('%');
                   const auto number = number_above_0(text.substr(0, text.size() - (is_percent ? 1 : 0)), is_percent ? 100.0 : 1e9);
                   if (!number || (!is_percent && !whole_number<std::int64_t>(text, 1))) return std::nullopt;
                   return SampleSize{*number, is_percent};
               });
    add_option(command, options.backend, {"--backend", "NAME", backends_listed() + " [auto]", backends_listed()}, backend_named);
    options.parse_render = parse_render;
    command.footer(std::string(verify_examples) + exit_codes);
}

void declare(CLI::App& command, DoctorOptions& options) {
    add_flag(command, options.json, "--json", "The report as JSON on stdout");
    add_option(command, options.timeout_seconds,
               {"--timeout", "S", "Seconds that each probe may take [20]", "a number of seconds above 0, at most 3600"},
               [](const std::string& text) { return number_above_0(text, 3600.0); });
    add_option(command, options.probe, {"--probe", "NAME", "", "one of doctor's probes"}, [](const std::string& text) {
        return std::optional(text);
    })->group("");
    command.footer(doctor_examples);
}

// Adds a command, which leaves in `chosen` what it does.
template <typename Options>
void add_command(CLI::App& app, Run& chosen, const std::string& name, ExitCode (*run)(const Options&), const std::string& help) {
    CLI::App* command = app.add_subcommand(name, help);
    const auto options = std::make_shared<Options>();
    declare(*command, *options);
    command->callback([=, &chosen] {
        check(*command, *options);
        chosen = [=] { return run(*options); };
    });
}

Run print(const std::string& text) {
    return [text] {
        write_output(std::string(standard_stream), text);
        return ExitCode::done;
    };
}

// Options of the program itself that print a text, as --version does.
void declare_texts(CLI::App& app) {
    const auto print_text = [](const std::string& text) { throw CLI::CallForVersion(text, 0); };
    app.add_flag_callback(
        "--licenses", [=] { print_text(licenses()); }, "Print the licences of this program and of the parts of others in it");
    app.add_flag_callback(
        "--man", [&app, print_text] { print_text(man_page(app, program_and_version)); }, "Print the manual page, in roff");
    const std::string shells = listed(completion_shells(), "or");
    static std::string unused;
    add_option(app, unused, {"--completion", "SHELL", "Print what completes this command line in a shell: " + shells, shells},
               [&app, print_text](const std::string& shell) -> std::optional<std::string> {
                   const std::string script = completion_script(app, shell);
                   if (!script.empty()) print_text(script);
                   return std::nullopt;
               });
}

// The command named by the first word; else adds `view`, which need not be named before its scene or options.
CLI::App& named_command(CLI::App& app, std::vector<std::string>& words) {
    const std::string first = words.empty() ? "" : words.front();
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    if (std::ranges::find(names, first) != names.end()) return *app.get_subcommand(first);
    if (is_option(first) && find_option(app, first.substr(0, first.find('='))) != nullptr) return app;
    std::error_code ignored;
    const bool path = first.find_first_of("/\\.") != std::string::npos || std::filesystem::exists(path_from(first), ignored);
    if (!words.empty() && !first.starts_with('-') && !path) {
        const std::string option = "--" + first;  // such as help
        throw CLI::ValidationError(
            "unknown command " + in_quotes(first) +
            (find_option(app, option) != nullptr ? "; did you mean '" + option + "'?" : did_you_mean(first, names)));
    }
    words.insert(words.begin(), "view");
    return *app.get_subcommand("view");
}

}  // namespace

Run parse_command_line(int argc, const char* const* argv) {
    const EndsWithoutMemory ends_without_memory;
    CLI::App app(
        "sphereview ray traces scenes of spheres.\n\n  sphereview [SCENE]        opens a scene in a window\n  sphereview COMMAND "
        "...    works without one\n",
        "sphereview");
    app.allow_windows_style_options(false);  // "/scenes/a.txt" is a file
    app.set_version_flag("--version", program_and_version);
    app.get_formatter()->label("Excludes", "Not with");  // as usage_error.cpp says it
    declare_texts(app);
    app.footer(exit_codes);
    app.require_subcommand(1);  // and no second: "doctor" behind it is a file's name
    Run chosen;
    add_command(app, chosen, "view", run_view, "Open a scene in a window (what is done when no command is named)");
    add_command(app, chosen, "render", run_render, "Render scenes to PNG files, without a window");
    add_command(app, chosen, "convert", run_convert, "Convert a scene to " + listed(format_names(is_written), "or"));
    add_command(app, chosen, "explain", run_explain,
                "Everything about one pixel: its ray, every hit, which sphere it shows and why");
    add_command(app, chosen, "compare", run_compare, "Say which mistakes explain how pictures of another ray tracer differ");
    add_command(app, chosen, "verify", run_verify, "Render pictures of a manifest again, and compare their sums");
    add_command(app, chosen, "doctor", run_doctor, "Try every backend and say what works here, and why others do not");
    std::vector<std::string> words(argv + 1, argv + argc);
    CLI::App* command = &app;
    try {
        command = &named_command(app, words);
        if (command->get_name() == "render") join_fit_first(words);
        const bool help = std::ranges::any_of(words, [](const auto& word) { return word == "-h" || word == "--help"; });
        if (help) return print(command->help(command == &app ? "" : app.get_name()));  // whatever else is wrong
        check_values(*command, words);
        app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        return chosen;
    } catch (const CLI::CallForVersion& asked) {  // or for another of the program's own texts
        return print(asked.what() + std::string("\n"));
    } catch (const CLI::ParseError& error) {
        throw InputError("sphereview: " + in_words(*command, error) + " (see 'sphereview " +
                         (command == &app ? "" : command->get_name() + " ") + "--help')");
    }
}

}  // namespace sphereview

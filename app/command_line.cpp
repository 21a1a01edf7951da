#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdlib>
#include <filesystem>

#include "app/version.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/text.hpp"
#include "image/image.hpp"

namespace sphereview {

namespace {

constexpr const char* exit_codes =
    "Exit status: 0 done; 1 the picture differs from the expected one; 2 wrong usage or a bad scene;\n"
    "3 nothing here could render, or memory ran out; 4 the output could not be written;\n"
    "130, 143 interrupted. Of several the highest counts.";

constexpr const char* render_examples =
    "Examples:\n"
    "  sphereview render scene.txt                        writes scene.png\n"
    "  sphereview render scene.toml -o - > picture.png\n"
    "  sphereview render *.txt -o 'out/{name}.png'\n"
    "  sphereview render scene.txt --expect golden.png    compares; writes nothing\n"
    "  generate | sphereview render - -s 640x480 -o picture.png\n";

constexpr const char* convert_examples =
    "Examples:\n"
    "  sphereview convert scene.txt scene.toml\n"
    "  sphereview convert scene.toml - --to text\n";

constexpr const char* explain_examples =
    "Examples:\n"
    "  sphereview explain scene.txt --pixel 665,334\n"
    "  sphereview explain scene.toml --pixel 10,20 --size 64x48 --json\n";

constexpr const char* doctor_examples =
    "Exit status 0 if any backend works, else 3.\n"
    "Examples:\n"
    "  sphereview doctor\n"
    "  sphereview doctor --json | jq .\n";

[[noreturn]] void wrong_usage(const std::string& what, const std::string& command = "") {
    throw InputError("sphereview: " + what + " (see 'sphereview " + (command.empty() ? "" : command + " ") + "--help')");
}

// What was typed, before it is checked.
struct Typed {
    RenderOptions render;
    ConvertOptions convert;
    ExplainOptions explain;
    DoctorOptions doctor;
    std::string pixel;
    bool no_certify = false;
    std::string size = "1000x1000";
    std::optional<std::string> background;
    std::optional<std::string> backend;
    std::optional<std::string> to;
};

void add_render(CLI::App& app, Typed& typed) {
    CLI::App* render = app.add_subcommand("render", "Render scenes to PNG files, without a window");
    RenderOptions& options = typed.render;
    render->add_option("SCENE", options.scenes, "Scene files, text or TOML; - is standard input")->required();
    render->add_option("-o,--output", options.output, "PNG file, or a pattern with {name}; - is standard output")
        ->type_name("FILE");
    render->add_option("-s,--size", typed.size, "Width and height in pixels [1000x1000]")->type_name("WxH");
    render->add_option("--background", typed.background, "Instead of the scene's: " + std::string(background_syntax))
        ->type_name("COLOR");
    render->add_option("--backend", typed.backend, std::string(backend_names) + " [auto, or SPHEREVIEW_BACKEND]")
        ->type_name("NAME");
    render->add_option("--device", options.device, "Number of an EGL device, as 'doctor' lists them")->type_name("N");
    render->add_option("--expect", options.expect, "Compare with this PNG ({name} with several scenes)")->type_name("GOLDEN");
    render->add_option("--diff", options.diff, "With --expect: write a picture of the difference")->type_name("FILE");
    render->add_flag("--no-certify", typed.no_certify,
                     "For comparison: keep float's best guess where float cannot tell which sphere is seen. What is lost: the "
                     "picture may differ by a few pixels from one machine to the next");
    render->add_flag("--timings", options.timings, "Say on stderr how long each phase took, in ms");
    render->add_flag("--json", options.json, "Report each scene as one JSON line on stdout");
    render->add_flag("--verbose", options.verbose, "Say on stderr which backend is used, and why");
    render->footer(std::string(render_examples) + exit_codes);
}

void add_convert(CLI::App& app, Typed& typed) {
    CLI::App* convert = app.add_subcommand("convert", "Convert a scene between the text format and TOML");
    convert->add_option("IN", typed.convert.input, "Scene file; - is standard input")->required();
    convert->add_option("OUT", typed.convert.output, "Scene file: .toml is TOML, all else text; - is standard output")->required();
    convert->add_option("--to", typed.to, "text or toml, whatever OUT is called")->type_name("FORMAT");
    convert->footer(std::string(convert_examples) + exit_codes);
}

void add_explain(CLI::App& app, Typed& typed) {
    CLI::App* explain =
        app.add_subcommand("explain", "Everything about one pixel: its ray, every hit, which sphere it shows and why");
    explain->add_option("SCENE", typed.explain.scene, "Scene file; - is standard input")->required();
    explain->add_option("-p,--pixel", typed.pixel, "Column from the left and row from the top, from 0")
        ->required()
        ->type_name("X,Y");
    explain->add_option("-s,--size", typed.size, "Width and height of the picture in pixels [1000x1000]")->type_name("WxH");
    explain->add_option("--background", typed.background, "Instead of the scene's: " + std::string(background_syntax))
        ->type_name("COLOR");
    explain->add_flag("--json", typed.explain.json, "The same as one JSON line");
    explain->footer(std::string(explain_examples) + exit_codes);
}

void add_doctor(CLI::App& app, Typed& typed) {
    CLI::App* doctor = app.add_subcommand("doctor", "Try every backend and say what works here, and why others do not");
    doctor->add_flag("--json", typed.doctor.json, "The report as JSON on stdout");
    doctor->add_option("--timeout", typed.doctor.timeout_seconds, "Seconds that each probe may take [20]")->type_name("S");
    doctor->add_option("--probe", typed.doctor.probe)->group("");  // hidden: what doctor's child processes run
    doctor->footer(doctor_examples);
}

// All names that an option of `app` has, with their dashes.
std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_group().empty()) continue;
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

// CLI11 keeps what it does not know; the first of it is the mistake.
void reject_extras(const CLI::App& app) {
    std::vector<std::string> extras = app.remaining();
    std::erase(extras, "--");  // that what follows are no options, it has heeded itself
    if (extras.empty()) return;
    const std::string word = extras.front().substr(0, extras.front().find('='));
    const bool is_option = word.starts_with('-');
    wrong_usage((is_option ? "unknown option " : "unexpected argument ") + in_quotes(word) +
                    (is_option ? did_you_mean(word, option_names(app)) : ""),
                app.get_name());
}

// A first word that is no command: say what it may have been meant as.
void check_first_word(const CLI::App& app, const std::string& word) {
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
    if (std::find(commands.begin(), commands.end(), word) != commands.end()) return;
    if (word.starts_with('-') && word != standard_stream) {
        const std::vector<std::string> known = {"--help", "-h", "--version"};
        if (std::find(known.begin(), known.end(), word) != known.end()) return;
        wrong_usage("unknown option " + in_quotes(word) + did_you_mean(word, known));
    }
    std::error_code ignored;
    const bool path =
        word == standard_stream || word.find_first_of("/\\.") != std::string::npos || std::filesystem::exists(word, ignored);
    if (path) wrong_usage("a scene is not a command; to render it: sphereview render " + word);
    wrong_usage("unknown command " + in_quotes(word) + did_you_mean(word, commands));
}

Backend chosen_backend(const Typed& typed) {
    if (typed.backend) {
        if (const auto backend = backend_named(*typed.backend)) return *backend;
        wrong_usage("--backend: found " + in_quotes(*typed.backend) + ", expected " + std::string(backend_names), "render");
    }
    const char* variable = std::getenv("SPHEREVIEW_BACKEND");
    if (variable == nullptr || *variable == '\0') return Backend::automatic;
    if (const auto backend = backend_named(variable)) return *backend;
    wrong_usage("SPHEREVIEW_BACKEND: found " + in_quotes(variable) + ", expected " + std::string(backend_names), "render");
}

// Two whole numbers with one of the separators between them.
struct NumberPair {
    bool well_formed = false;
    bool too_large = false;  // one of them is beyond an int
    int first = 0;
    int second = 0;
};

NumberPair parse_pair(const std::string& text, std::string_view separators) {
    NumberPair pair;
    const char* last = text.data() + text.size();
    const auto first = std::from_chars(text.data(), last, pair.first);
    if (first.ptr == last || separators.find(*first.ptr) == std::string_view::npos) return pair;
    const auto second = std::from_chars(first.ptr + 1, last, pair.second);
    pair.well_formed = second.ptr == last && second.ptr != first.ptr + 1 && first.ptr != text.data();
    pair.too_large = first.ec != std::errc{} || second.ec != std::errc{};
    return pair;
}

std::optional<Background> checked_background(const std::optional<std::string>& text) {
    Background background;
    if (!text) return std::nullopt;
    if (parse_background(*text, background)) return background;
    wrong_usage("--background: found " + in_quotes(*text) + ", expected " + std::string(background_syntax));
}

RenderOptions checked_render(const Typed& typed) {
    RenderOptions options = typed.render;
    options.size = parse_size(typed.size);
    options.certify = !typed.no_certify;
    options.background = checked_background(typed.background);
    options.backend = chosen_backend(typed);
    if (options.device) {
        const bool explicitly = typed.backend && options.backend != Backend::automatic;
        if (explicitly && options.backend != Backend::egl) {
            wrong_usage("--device picks an EGL device, which --backend " + *typed.backend + " does not use", "render");
        }
        options.backend = Backend::egl;  // a device named on the command line counts more than the environment
    }
    if (options.diff && !options.expect) wrong_usage("--diff needs --expect", "render");
    return options;
}

ExplainOptions checked_explain(const Typed& typed) {
    ExplainOptions options = typed.explain;
    options.size = parse_size(typed.size);
    options.background = checked_background(typed.background);
    const NumberPair pair = parse_pair(typed.pixel, ",");
    if (!pair.well_formed) wrong_usage("--pixel: found " + in_quotes(typed.pixel) + ", expected X,Y, such as 500,500", "explain");
    if (pair.too_large || pair.first < 0 || pair.second < 0 || pair.first >= options.size.width ||
        pair.second >= options.size.height) {
        wrong_usage("--pixel: found " + in_quotes(typed.pixel) + ", expected a pixel from 0,0 to " +
                        std::to_string(options.size.width - 1) + "," + std::to_string(options.size.height - 1),
                    "explain");
    }
    options.pixel = {pair.first, pair.second};
    return options;
}

ConvertOptions checked_convert(const Typed& typed) {
    ConvertOptions options = typed.convert;
    if (typed.to == "text") {
        options.to = SceneFormat::text;
    } else if (typed.to == "toml") {
        options.to = SceneFormat::toml;
    } else if (typed.to) {
        wrong_usage("--to: found " + in_quotes(*typed.to) + ", expected text or toml", "convert");
    } else if (options.output == standard_stream) {
        wrong_usage("standard output has no name to tell the format; add --to text or --to toml", "convert");
    }
    return options;
}

std::string one_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    for (char& c : text) {
        if (c == '\n' || c == '\r') c = ' ';
    }
    return text;
}

}  // namespace

PictureSize parse_size(const std::string& text) {
    const auto fail = [&](const std::string& expected) {
        wrong_usage("--size: found " + in_quotes(text) + ", expected " + expected);
    };
    const NumberPair pair = parse_pair(text, "xX,");
    if (!pair.well_formed) fail("WIDTHxHEIGHT, such as 1000x1000");
    if (pair.too_large || (pair.first > 0 && pair.second > 0 && pair.first > most_pixels / pair.second)) {
        fail("at most " + std::to_string(most_pixels) + " pixels");
    }
    if (pair.first < 1 || pair.second < 1) fail("sides of at least 1 pixel");
    return {pair.first, pair.second};
}

Command parse_command_line(int argc, const char* const* argv) {
    CLI::App app("sphereview ray traces scenes of spheres.", "sphereview");
    app.set_version_flag("--version", "sphereview " + std::string(version));
    app.footer(exit_codes);
    Typed typed;
    add_render(app, typed);
    add_convert(app, typed);
    add_explain(app, typed);
    add_doctor(app, typed);
    for (CLI::App* command : app.get_subcommands({})) command->allow_extras();
    app.require_subcommand(1);  // and no second: "doctor" behind it is a file's name

    if (argc < 2) wrong_usage("expected a command: render, convert, explain or doctor");
    check_first_word(app, argv[1]);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return PrintText{app.help()};
    } catch (const CLI::CallForVersion&) {
        return PrintText{app.version() + "\n"};
    } catch (const CLI::ParseError& error) {
        const auto commands = app.get_subcommands();
        for (const CLI::App* command : commands) reject_extras(*command);
        wrong_usage(one_line(error.what()), commands.empty() ? "" : commands.front()->get_name());
    }
    const CLI::App& command = *app.get_subcommands().front();
    reject_extras(command);
    if (command.get_name() == "render") return checked_render(typed);
    if (command.get_name() == "convert") return checked_convert(typed);
    if (command.get_name() == "explain") return checked_explain(typed);
    if (!(typed.doctor.timeout_seconds > 0.0) || typed.doctor.timeout_seconds > 3600.0) {
        wrong_usage("--timeout: expected seconds above 0, at most 3600", "doctor");
    }
    return typed.doctor;
}

}  // namespace sphereview

#include "app/command_line.hpp"

#include <CLI/CLI.hpp>

#include "app/argument_check.hpp"
#include "app/typed_options.hpp"
#include "app/version.hpp"
#include "base/error.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

constexpr const char* exit_codes =
    "Exit status: 0 done; 1 the picture differs from the expected one; 2 wrong usage or a bad scene;\n"
    "3 nothing here could render, or memory ran out; 4 the output could not be written;\n"
    "129, 130, 143 interrupted. Of several the highest counts.";

constexpr const char* view_examples =
    "The command's name may be left out: sphereview scene.txt\n"
    "Examples:\n"
    "  sphereview scene.txt                               drag, scroll, edit; F1 lists keys and mouse\n"
    "  sphereview scene.toml --background white\n"
    "  generate | sphereview -                            an untitled scene\n";

constexpr const char* render_examples =
    "Examples:\n"
    "  sphereview render scene.txt                        writes scene.png\n"
    "  sphereview render scene.toml -o - > picture.png\n"
    "  sphereview render *.txt -o 'out/{name}.png'\n"
    "  sphereview render scene.txt --expect golden.png    compares; writes nothing\n"
    "  sphereview render data.xyz --view iso              everything, seen from a corner\n"
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

const std::string scene_files = "Scene file: " + listed(format_names(), "or") + "; - is standard input";

// For files of atoms and particles.
void add_data_options(CLI::App& command, TypedOptions& typed) {
    command
        .add_option("--frame", typed.frame,
                    "Which frame of several, from 0 [0]: " + listed(format_names(has_frames), "and") + " have them")
        ->type_name("N");
    command.add_option("--radius", typed.radius, "Of spheres for which the file says none [the element's, in CSV 1]")
        ->type_name("R");
}

void add_fit_options(CLI::App& command, TypedOptions& typed) {
    command.add_flag("--fit", typed.fit,
                     "Move the camera so that it sees everything, the way it looks; usual for data such as XYZ");
    command.add_flag("--no-fit", typed.no_fit, "Look at data, too, from (0, 0, 0) along z");
    command.add_option("--view", typed.view_from, "Fit, from another side: " + std::string(view_syntax))->type_name("SIDE");
}

void add_shade(CLI::App* command, TypedOptions& typed, const std::string& otherwise) {
    command->add_option("--shade", typed.shading, std::string(shading_syntax) + " [" + otherwise + "]")->type_name("MODE");
}

CLI::App* add_view(CLI::App& app, TypedOptions& typed) {
    CLI::App* view = app.add_subcommand("view", "Open a scene in a window (what is done when no command is named)");
    view->add_option("SCENE", typed.view.scene, scene_files + "; none: an empty scene");
    add_data_options(*view, typed);
    add_fit_options(*view, typed);
    view->add_option("-s,--size", typed.view_size, "Width and height of exports in pixels [as last time, at first 1000x1000]")
        ->type_name("WxH");
    view->add_option("--samples", typed.samples,
                     "Anti-aliasing of exports and of the window at rest: points a pixel, 1, 4 or 16 [as last time, at first 1]")
        ->type_name("N");
    view->add_option("--background", typed.background, "Instead of the scene's: " + std::string(background_syntax))
        ->type_name("COLOR");
    add_shade(view, typed, "as last time, at first flat");
    view->add_option("--shader-dir", typed.view.shader_folder,
                     "Use the shaders in this folder, and each that is saved there at once")
        ->type_name("FOLDER");
    view->add_option("--redraw-log", typed.view.redraw_log)->type_name("FILE")->group("");  // hidden: for tests
    view->footer(std::string(view_examples) + exit_codes);
    return view;
}

void add_render(CLI::App& app, TypedOptions& typed) {
    CLI::App* render = app.add_subcommand("render", "Render scenes to PNG files, without a window");
    RenderOptions& options = typed.render;
    render->add_option("SCENE", options.scenes, scene_files)->required();
    render->add_option("-o,--output", options.output, "PNG file, or a pattern with {name}; - is standard output")
        ->type_name("FILE");
    render->add_option("-s,--size", typed.size, "Width and height in pixels [1000x1000]")->type_name("WxH");
    render->add_option("--samples", typed.samples, "Anti-aliasing: points a pixel, whose colours are averaged: 1, 4 or 16 [1]")
        ->type_name("N");
    add_data_options(*render, typed);
    add_fit_options(*render, typed);
    render->add_option("--background", typed.background, "Instead of the scene's: " + std::string(background_syntax))
        ->type_name("COLOR");
    add_shade(render, typed, "flat");
    render->add_option("--backend", typed.backend, std::string(backend_names) + " [auto, or SPHEREVIEW_BACKEND]")
        ->type_name("NAME");
    render->add_option("--device", typed.device, "Number of an EGL device, as 'doctor' lists them")->type_name("N");
    render->add_option("--expect", options.expect, "Compare with this PNG ({name} with several scenes)")->type_name("GOLDEN");
    render->add_option("--diff", options.diff, "With --expect: write a picture of the difference")->type_name("FILE");
    render->add_flag("--no-certify", typed.no_certify,
                     "For comparison: keep float's best guess where float cannot tell which sphere is seen. What is lost: the "
                     "picture may differ by a few pixels from one machine to the next");
    render->add_flag("--timings", options.timings, "Say on stderr how long each phase took, in ms");
    render->add_flag("--json", options.json, "Report each scene as one JSON line on stdout");
    render->add_flag(
        "--verbose", options.verbose,
        "Say on stderr which backend is used and why, in which tiles the spheres are, and how the pixels were decided");
    render->footer(std::string(render_examples) + exit_codes);
}

void add_convert(CLI::App& app, TypedOptions& typed) {
    CLI::App* convert = app.add_subcommand("convert", "Convert a scene to " + listed(format_names(is_written), "or"));
    convert->add_option("IN", typed.convert.input, scene_files)->required();
    convert->add_option("OUT", typed.convert.output, "Scene file: .toml is TOML, all else text; - is standard output")->required();
    convert->add_option("--to", typed.to, lower_case(listed(format_names(is_written), "or")) + ", whatever OUT is called")
        ->type_name("FORMAT");
    add_data_options(*convert, typed);
    add_fit_options(*convert, typed);
    convert->footer(std::string(convert_examples) + exit_codes);
}

void add_explain(CLI::App& app, TypedOptions& typed) {
    CLI::App* explain =
        app.add_subcommand("explain", "Everything about one pixel: its ray, every hit, which sphere it shows and why");
    explain->add_option("SCENE", typed.explain.scene, scene_files)->required();
    explain->add_option("-p,--pixel", typed.pixel, "Column from the left and row from the top, from 0")
        ->required()
        ->type_name("X,Y");
    explain->add_option("-s,--size", typed.size, "Width and height of the picture in pixels [1000x1000]")->type_name("WxH");
    add_data_options(*explain, typed);
    add_fit_options(*explain, typed);
    explain->add_option("--background", typed.background, "Instead of the scene's: " + std::string(background_syntax))
        ->type_name("COLOR");
    add_shade(explain, typed, "flat");
    explain->add_flag("--json", typed.explain.json, "The same as one JSON line");
    explain->footer(std::string(explain_examples) + exit_codes);
}

void add_doctor(CLI::App& app, TypedOptions& typed) {
    CLI::App* doctor = app.add_subcommand("doctor", "Try every backend and say what works here, and why others do not");
    doctor->add_flag("--json", typed.doctor.json, "The report as JSON on stdout");
    doctor->add_option("--timeout", typed.timeout, "Seconds that each probe may take [20]")->type_name("S");
    doctor->add_option("--probe", typed.doctor.probe)->group("");  // hidden: what doctor's child processes run
    doctor->footer(doctor_examples);
}

std::string one_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    for (char& c : text) {
        if (c == '\n' || c == '\r') c = ' ';
    }
    return text;
}

// The command of that name, or null.
const CLI::App* command_named(const CLI::App& app, const std::string& name) {
    const auto named = app.get_subcommands([&](const CLI::App* command) { return command->get_name() == name; });
    return named.empty() ? nullptr : named.front();
}

// What `app` makes of the words; throws WrongUsage.
Command parse(CLI::App& app, TypedOptions& typed, int argc, const char* const* argv) {
    const CLI::App* command = command_named(app, argv[1]);
    Arguments arguments;
    if (command != nullptr) arguments = check_options(*command, {argv + 2, static_cast<std::size_t>(argc - 2)});
    if (arguments.help) return PrintText{command->help(app.get_name())};
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return PrintText{app.help()};
    } catch (const CLI::CallForVersion&) {
        return PrintText{app.version() + "\n"};
    } catch (const CLI::ParseError& error) {
        if (command != nullptr) check_complete(*command);
        throw WrongUsage(one_line(error.what()));
    }
    command = app.get_subcommands().front();
    check_complete(*command);
    if (command->get_name() == "render") {
        typed.render.scenes = arguments.files;  // CLI11 takes a file called [a,b] for two
        return checked_render(typed);
    }
    if (command->get_name() == "view") return checked_view(typed);
    if (command->get_name() == "convert") return checked_convert(typed);
    if (command->get_name() == "explain") return checked_explain(typed);
    return checked_doctor(typed);
}

}  // namespace

Command parse_command_line(int argc, const char* const* argv) {
    CLI::App app(
        "sphereview ray traces scenes of spheres.\n\n  sphereview [SCENE]        opens a scene in a window\n  sphereview COMMAND "
        "...    works without one\n",
        "sphereview");
    app.set_version_flag("--version", "sphereview " + std::string(version));
    app.footer(exit_codes);
    TypedOptions typed;
    const CLI::App* view = add_view(app, typed);
    add_render(app, typed);
    add_convert(app, typed);
    add_explain(app, typed);
    add_doctor(app, typed);
    for (CLI::App* command : app.get_subcommands({})) command->allow_extras();
    app.require_subcommand(1);  // and no second: "doctor" behind it is a file's name
    std::vector<const char*> words(argv, argv + argc);
    try {
        if (words.size() < 2 || begins_usual_command(app, *view, words[1])) words.insert(words.begin() + 1, "view");
        return parse(app, typed, static_cast<int>(words.size()), words.data());
    } catch (const WrongUsage& mistake) {
        const bool known = words.size() > 1 && command_named(app, words[1]) != nullptr;
        const std::string command = known ? std::string(words[1]) + " " : "";
        throw InputError(std::string("sphereview: ") + mistake.what() + " (see 'sphereview " + command + "--help')");
    }
}

}  // namespace sphereview

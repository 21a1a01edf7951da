// The texts below the options in --help; the manual page and completions, which are written from the declarations in
// command_line.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace sphereview {

inline constexpr const char* exit_codes =
    "Exit status: 0 done; 1 the picture differs from the expected one; 2 wrong usage or a bad scene;\n"
    "3 nothing here could render, or memory ran out; 4 the output could not be written;\n"
    "129, 130, 143 interrupted. Of several the highest counts.";

inline constexpr const char* view_examples =
    "The command's name may be left out: sphereview scene.txt\n"
    "Examples:\n"
    "  sphereview scene.txt                               drag, scroll, edit; F1 lists keys and mouse\n"
    "  sphereview scene.toml --background white\n"
    "  generate | sphereview -                            an untitled scene\n";

inline constexpr const char* render_examples =
    "Examples:\n"
    "  sphereview render scene.txt                        writes scene.png\n"
    "  sphereview render scene.toml -o - > picture.png\n"
    "  sphereview render *.txt -o 'out/{name}.png'\n"
    "  sphereview render scene.txt --expect golden.png    compares; writes nothing\n"
    "  sphereview render data.xyz --view iso              everything, seen from a corner\n"
    "  sphereview render traj.xyz --frames 0:100:5 -o 'out/{frame:05}.png'\n"
    "  generate | sphereview render - -s 640x480 -o picture.png\n";

inline constexpr const char* convert_examples =
    "Examples:\n"
    "  sphereview convert scene.txt scene.toml\n"
    "  sphereview convert scene.toml - --to text\n";

inline constexpr const char* explain_examples =
    "Examples:\n"
    "  sphereview explain scene.txt --pixel 665,334\n"
    "  sphereview explain scene.toml --pixel 10,20 --size 64x48 --json\n";

inline constexpr const char* compare_examples =
    "Pictures are PNG, PPM, PGM or BMP; each is compared with the flat picture of its own size.\n"
    "Examples:\n"
    "  sphereview compare mine.png scene.txt              which mistake explains what differs\n"
    "  sphereview compare students/*.png scene.txt --json\n";

inline constexpr const char* verify_examples =
    "Run it where the pictures were rendered, or where their scenes are under the same names. Exit status 0: all are equal; 1: "
    "some differ.\n"
    "Examples:\n"
    "  sphereview render traj.xyz --frames all -o 'out/{frame:05}.png' --manifest out/manifest.jsonl\n"
    "  sphereview verify out/manifest.jsonl --sample 1%\n";

inline constexpr const char* doctor_examples =
    "Exit status 0 if any backend works, else 3.\n"
    "Examples:\n"
    "  sphereview doctor\n"
    "  sphereview doctor --json | jq .\n";

// Expected values in messages. Completions offer files or folders for these.
inline constexpr const char* a_file = "the name of a file";
inline constexpr const char* a_folder = "a folder";

// The options and positional arguments that --help shows.
template <typename App>
auto shown_options(App& command) {
    auto options = command.get_options();
    std::erase_if(options, [](const CLI::Option* option) { return option->get_group().empty(); });
    return options;
}

// The manual page, in roff, without an end of line behind the last line.
std::string man_page(const CLI::App& app, const std::string& program_and_version);

// The shells that completion_script() knows.
std::vector<std::string> completion_shells();

// A script that completes commands, options and their values in that shell; "" for an unknown shell. Without an end of line behind
// the last line. Clears the values of options.
std::string completion_script(CLI::App& app, const std::string& shell);

}  // namespace sphereview

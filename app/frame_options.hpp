// The options of `render` that are about several pictures of a scene.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/options.hpp"

namespace sphereview {

void add_frame_options(CLI::App& command, RenderOptions& options);
// The options that were given and that say what pictures look like, as words of a command line.
std::vector<std::string> picture_words(const CLI::App& command);
// Throws CLI::ParseError for words of a manifest that picture_words() would not give, as --help, which no picture has.
void require_picture_words(const CLI::App& command, const std::vector<std::string>& words);
// Throws CLI::ParseError for options that do not go together.
void check_frame_options(const CLI::App& command, const RenderOptions& options);
// `--fit first` as the option that stands for it: --fit alone takes no value, and may stand before a scene.
void join_fit_first(std::vector<std::string>& words);

}  // namespace sphereview

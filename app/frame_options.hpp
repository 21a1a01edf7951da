// The options of `render` for several pictures of a scene.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/options.hpp"

namespace sphereview {

void add_frame_options(CLI::App& command, RenderOptions& options);
// The given options that change what pictures look like, as words of a command line.
std::vector<std::string> picture_words(const CLI::App& command);
// Throws CLI::ParseError for words of a manifest that picture_words() never gives, such as --help.
void require_picture_words(const CLI::App& command, const std::vector<std::string>& words);
// Throws CLI::ParseError for options that do not go together.
void check_frame_options(const CLI::App& command, const RenderOptions& options);
// Turns `--fit first` into one internal option: --fit alone takes no value and may stand before a scene.
void join_fit_first(std::vector<std::string>& words);

}  // namespace sphereview

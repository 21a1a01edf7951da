// Options that several commands have.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string>

#include "app/add_option.hpp"
#include "app/light_options.hpp"
#include "app/load_scene.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/lines.hpp"
#include "image/image.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"
#include "shade/shading.hpp"

namespace sphereview {

inline std::string scene_files() { return "Scene file: " + listed(format_names(), "or") + "; - is standard input"; }

// Options for reading scenes and for their cameras, of every command with scenes.
inline void add_scene_options(CLI::App& command, DataOptions& data, FitOptions& fit) {
    add_option(command, data.frame,
               {"--frame", "N", "Which frame of several, from 0 [0]: " + listed(format_names(has_frames), "and") + " have them",
                "the number of a frame, from 0"},
               [](const std::string& text) { return whole_number<std::int64_t>(text, 0); });
    add_option(command, data.radius,
               {"--radius", "R", "Of spheres for which the file says none [the element's, or by the distances of points]",
                "a number above 0"},
               [](const std::string& text) { return number_above_0(text); });
    add_option(command, data.columns,
               {"--columns", "LIST",
                "Columns of a " + listed(format_names(has_columns), "or") +
                    " file: x=NAME,y=NAME,z=NAME,radius=NAME; numbers from 1 do as well",
                column_choices_syntax},
               [](const std::string& text) { return parse_column_choices(text); });
    add_flag(command, data.virtual_sites, "--no-virtual",
             "Leave out what files of atoms call one and is none: virtual sites, lone pairs, Drude particles, ghosts, dummies",
             false);
    add_flag(command, data.index_from, "--no-index",
             "Neither keep where the frames of a large file stand, nor use what was kept of it", std::nullopt);
    CLI::Option* wanted = add_flag(command, fit.wanted, "--fit",
                                   "Move the camera so that it sees everything, the way it looks; usual for data such as XYZ");
    CLI::Option* forbidden = add_flag(command, fit.wanted, "--no-fit", "Look at data, too, from (0, 0, 0) along z", false);
    const std::string views(any_view_syntax);
    CLI::Option* side =
        add_option(command, fit, {"--view", "VIEW", "Fit, from another side, or show a saved view: " + views, views},
                   [&fit](const std::string& text) -> std::optional<FitOptions> {
                       std::optional<FitOptions> asked = fit_from(text);
                       if (asked) {
                           asked->projection = fit.projection;
                           asked->camera = fit.camera;
                       }
                       return asked;
                   });
    add_option(command, fit.projection,
               {"--projection", "NAME",
                "perspective or orthographic, instead of the scene's camera's; with --fit the screen, too, is made for it",
                "perspective or orthographic"},
               [](const std::string& text) { return projection_named(text); });
    forbidden->excludes(wanted)->excludes(side);
}

// The option for properties, which are read besides place, size and colour.
inline void add_properties(CLI::App& command, DataOptions& data) {
    add_option(command, data,
               {"--properties", "LIST", "Keep what the file holds of each sphere: all, or names with commas between",
                "all, or names with commas between"},
               [&data](const std::string& text) -> std::optional<DataOptions> {
                   DataOptions asked = data;
                   for (const std::string_view word : words_of(text, ",")) {
                       const std::string_view name = trimmed(word);
                       if (!name.empty()) asked.properties.emplace_back(name);
                   }
                   if (asked.properties.empty()) return std::nullopt;
                   if (asked.properties.size() == 1 && lower_case(asked.properties[0]) == "all") {
                       asked.properties.clear();
                       asked.all_properties = true;
                   }
                   return asked;
               });
}

template <typename Size>
void add_size(CLI::App& command, Size& size, const std::string& help) {
    const std::string expected =
        "WIDTHxHEIGHT, such as 1000x1000: sides of at least 1 pixel, at most " + std::to_string(most_pixels) + " pixels";
    add_option(command, size, {"-s,--size", "WxH", help, expected}, [](const std::string& text) -> std::optional<PictureSize> {
        const auto sides = whole_numbers(text, "xX,", 1);
        if (!sides || sides->first > most_pixels / sides->second) return std::nullopt;
        return PictureSize{sides->first, sides->second};
    });
}

template <typename Samples>
void add_samples(CLI::App& command, Samples& samples, const std::string& help) {
    add_option(command, samples, {"--samples", "N", help, sample_counts_text}, [](const std::string& text) -> std::optional<int> {
        const auto count = whole_number(text, 1);
        return count && std::ranges::find(sample_counts, *count) != sample_counts.end() ? count : std::nullopt;
    });
}

inline std::optional<Background> background_named(const std::string& text) {
    Background found;
    return parse_background(text, found) ? std::optional(found) : std::nullopt;
}

template <typename Mode>
void add_colors(CLI::App& command, std::optional<Background>& background, Mode& shading, const std::string& otherwise) {
    const std::string colors(background_syntax);
    add_option(command, background, {"--background", "COLOR", "Instead of the scene's: " + colors, colors}, background_named);
    const std::string modes = shading_syntax();
    add_option(command, shading, {"--shade", "MODE", modes + " [" + otherwise + "]", modes},
               [](const std::string& text) { return shading_named(text); });
}

// Options for the shading `studio`.
inline void add_light(CLI::App& command, LightOptions& light) {
    add_option(command, light.lights,
               {"--lights", "K",
                "With --shade studio: directions of the sky's light [the scene's; 256, or 64 with --samples or many spheres]",
                lights_syntax()},
               [](const std::string& text) {
                   const auto number = whole_number(text, fewest_lights);
                   return number && is_light_count(*number) ? number : std::nullopt;
               });
    const auto part = [](double most) {
        return [most](const std::string& text) -> std::optional<double> {
            double number = 0.0;
            const bool good = parse_double(text, number) == NumberFault::none && is_part(number, most);
            return good ? std::optional(number) : std::nullopt;
        };
    };
    const auto add_part = [&](std::optional<double>& value, const char* name, const std::string& help, double most,
                              const std::string& otherwise) {
        const std::string range = "0 to " + shortest(most);
        add_option(command, value, {name, "S", help + ", " + range + " [the scene's; " + otherwise + "]", part_syntax(most)},
                   part(most));
    };
    add_part(light.sky, "--sky", "Strength of the sky and the key light in it", most_sky,
             "1, or " + shortest(sky_beside_sun) + " beside a sun");
    add_part(light.key, "--key", "How much brighter the sky is around the key light", most_key, "1");
    const std::string directions(sun_syntax);
    add_option(command, light.sun, {"--sun", "DIR", "A sun: " + directions, directions},
               [](const std::string& text) { return parse_sun(text); });
    add_option(command, light.sun_strength,
               {"--sun-strength", "S",
                "Strength of the sun, " + shortest(weakest_sun) + " to " + shortest(strongest_sun) + " [the scene's; " +
                    shortest(sun_beside_sky) + ", or 1 where the sky's is said]",
                sun_strength_syntax()},
               [](const std::string& text) {
                   const auto strength = number_above_0(text, strongest_sun);
                   return strength && is_sun_strength(*strength) ? strength : std::nullopt;
               });
}

// Throws for an option about light without that shading.
inline void check_shows_light(const std::string& option, Shading shading) {
    if (!is_lit(shading)) throw CLI::ValidationError(option + " needs --shade studio");
}

inline void check_light(const LightOptions& light, Shading shading) {
    if (!light.any()) return;
    const std::string option = light.lights ? "--lights"
                               : light.sky  ? "--sky"
                               : light.key  ? "--key"
                               : light.sun  ? "--sun"
                                            : "--sun-strength";
    check_shows_light(option, shading);
}

}  // namespace sphereview

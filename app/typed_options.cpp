#include "app/typed_options.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>

#include "app/render_picture.hpp"
#include "base/input_file.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "image/image.hpp"
#include "scene/samples.hpp"

namespace sphereview {

namespace {

[[noreturn]] void wrong(const std::string& option, std::string_view found, const std::string& expected) {
    throw WrongUsage(option + ": found " + in_quotes(found) + ", expected " + expected);
}

// An empty name is mostly a script's variable that was never set.
void check_file_name(const std::string& option, const std::optional<std::string>& name) {
    if (name && name->empty()) wrong(option, *name, "the name of a file");
}

Backend chosen_backend(const TypedOptions& typed) {
    const std::string expected(backend_names);
    if (typed.backend) {
        if (const auto backend = backend_named(*typed.backend)) return *backend;
        wrong("--backend", *typed.backend, expected);
    }
    const char* variable = std::getenv("SPHEREVIEW_BACKEND");
    if (variable == nullptr || *variable == '\0') return Backend::automatic;
    if (const auto backend = backend_named(variable)) return *backend;
    wrong("SPHEREVIEW_BACKEND", variable, expected);
}

std::optional<int> checked_device(const std::optional<std::string>& text) {
    if (!text) return std::nullopt;
    int number = 0;
    const char* last = text->data() + text->size();
    const auto read = std::from_chars(text->data(), last, number);
    if (read.ec != std::errc{} || read.ptr != last || number < 0) {
        wrong("--device", *text, "the number of an EGL device, as 'sphereview doctor' lists them");
    }
    return number;
}

std::optional<Background> checked_background(const std::optional<std::string>& text) {
    Background background;
    if (!text) return std::nullopt;
    if (!parse_background(*text, background)) wrong("--background", *text, std::string(background_syntax));
    return background;
}

std::optional<Shading> checked_shading(const std::optional<std::string>& text) {
    if (!text) return std::nullopt;
    const std::optional<Shading> shading = shading_named(*text);
    if (!shading) wrong("--shade", *text, std::string(shading_syntax));
    return shading;
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

PictureSize checked_size(const std::string& text) {
    const NumberPair pair = parse_pair(text, "xX,");
    if (!pair.well_formed) wrong("--size", text, "WIDTHxHEIGHT, such as 1000x1000");
    if (pair.too_large || (pair.first > 0 && pair.second > 0 && pair.first > most_pixels / pair.second)) {
        wrong("--size", text, "at most " + std::to_string(most_pixels) + " pixels");
    }
    if (pair.first < 1 || pair.second < 1) wrong("--size", text, "sides of at least 1 pixel");
    return {pair.first, pair.second};
}

std::optional<int> checked_samples(const std::optional<std::string>& text) {
    if (!text) return std::nullopt;
    for (const int count : sample_counts) {
        if (*text == std::to_string(count)) return count;
    }
    wrong("--samples", *text, sample_counts_text);
}

void check_sampled_size(const std::string& text, PictureSize size, int samples) {
    const int longest = longest_side(samples);
    if (std::max(size.width, size.height) <= longest) return;
    wrong("--size", text, "sides of at most " + std::to_string(longest) + " pixels with --samples " + std::to_string(samples));
}

Pixel checked_pixel(const std::string& text, PictureSize size) {
    const NumberPair pair = parse_pair(text, ",");
    if (!pair.well_formed) wrong("--pixel", text, "X,Y, such as 500,500");
    if (pair.too_large || pair.first < 0 || pair.second < 0 || pair.first >= size.width || pair.second >= size.height) {
        wrong("--pixel", text, "a pixel from 0,0 to " + std::to_string(size.width - 1) + "," + std::to_string(size.height - 1));
    }
    return {pair.first, pair.second};
}

DataOptions checked_data(const TypedOptions& typed) {
    DataOptions data;
    if (typed.frame) {
        const char* last = typed.frame->data() + typed.frame->size();
        const auto read = std::from_chars(typed.frame->data(), last, data.frame);
        if (read.ec != std::errc{} || read.ptr != last || data.frame < 0) {
            wrong("--frame", *typed.frame, "the number of a frame, from 0");
        }
    }
    if (typed.radius) {
        double radius = 0.0;
        if (parse_double(*typed.radius, radius) != NumberFault::none || !(radius > 0.0)) {
            wrong("--radius", *typed.radius, "a number above 0");
        }
        data.radius = radius;
    }
    return data;
}

FitOptions checked_fit(const TypedOptions& typed) {
    FitOptions fit;
    if (typed.view_from) {
        fit.view = parse_view(*typed.view_from);
        if (!fit.view) wrong("--view", *typed.view_from, std::string(view_syntax));
    }
    const bool fits = typed.fit || typed.view_from;
    if (fits && typed.no_fit) throw WrongUsage(std::string(typed.fit ? "--fit" : "--view") + " and --no-fit contradict each other");
    if (fits || typed.no_fit) fit.wanted = fits;
    return fit;
}

}  // namespace

ViewOptions checked_view(const TypedOptions& typed) {
    ViewOptions options = typed.view;
    options.data = checked_data(typed);
    options.fit = checked_fit(typed);
    check_file_name("SCENE", options.scene);
    std::error_code ignored;
    if (!options.shader_folder.empty() && !std::filesystem::is_directory(options.shader_folder, ignored)) {
        wrong("--shader-dir", options.shader_folder, "a folder");
    }
    if (typed.view_size) options.size = checked_size(*typed.view_size);
    options.samples = checked_samples(typed.samples);
    options.background = checked_background(typed.background);
    options.shading = checked_shading(typed.shading);
    return options;
}

RenderOptions checked_render(const TypedOptions& typed) {
    RenderOptions options = typed.render;
    options.data = checked_data(typed);
    options.fit = checked_fit(typed);
    for (const std::string& scene : options.scenes) check_file_name("SCENE", scene);
    check_file_name("--output", options.output);
    check_file_name("--expect", options.expect);
    check_file_name("--diff", options.diff);
    options.size = checked_size(typed.size);
    options.samples = checked_samples(typed.samples).value_or(sample_counts.front());
    check_sampled_size(typed.size, options.size, options.samples);
    options.certify = !typed.no_certify;
    options.background = checked_background(typed.background);
    options.shading = checked_shading(typed.shading).value_or(Shading::flat);
    options.backend = chosen_backend(typed);
    options.device = checked_device(typed.device);
    if (options.device) {
        const bool explicitly = typed.backend && options.backend != Backend::automatic;
        if (explicitly && options.backend != Backend::egl) {
            throw WrongUsage("--device picks an EGL device, which --backend " + *typed.backend + " does not use");
        }
        options.backend = Backend::egl;  // a device named on the command line counts more than the environment
    }
    if (options.diff && !options.expect) throw WrongUsage("--diff needs --expect");
    return options;
}

ConvertOptions checked_convert(const TypedOptions& typed) {
    ConvertOptions options = typed.convert;
    options.data = checked_data(typed);
    options.fit = checked_fit(typed);
    check_file_name("IN", options.input);
    check_file_name("OUT", options.output);
    if (typed.to) {
        const SceneFormat* format = find_format(*typed.to);
        if (format == nullptr || !is_written(*format)) wrong("--to", *typed.to, lower_case(listed(format_names(is_written), "or")));
        options.to = *format;
    } else if (options.output == standard_stream) {
        throw WrongUsage("standard output has no name to tell the format; add --to text or --to toml");
    }
    return options;
}

ExplainOptions checked_explain(const TypedOptions& typed) {
    ExplainOptions options = typed.explain;
    options.data = checked_data(typed);
    options.fit = checked_fit(typed);
    check_file_name("SCENE", options.scene);
    options.size = checked_size(typed.size);
    options.background = checked_background(typed.background);
    options.shading = checked_shading(typed.shading).value_or(Shading::flat);
    options.pixel = checked_pixel(typed.pixel, options.size);
    return options;
}

DoctorOptions checked_doctor(const TypedOptions& typed) {
    DoctorOptions options = typed.doctor;
    if (!typed.timeout) return options;
    double& seconds = options.timeout_seconds;
    const bool number = parse_double(*typed.timeout, seconds) == NumberFault::none;
    if (!number || !(seconds > 0.0) || seconds > 3600.0) {
        wrong("--timeout", *typed.timeout, "a number of seconds above 0, at most 3600");
    }
    return options;
}

}  // namespace sphereview

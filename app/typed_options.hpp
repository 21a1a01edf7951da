// What was typed on the command line -> options that make sense.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "app/options.hpp"

namespace sphereview {

// A mistake in the command line: what was found, what was expected. parse_command_line adds where the help is.
struct WrongUsage : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// What was typed, before it is checked.
struct TypedOptions {
    ViewOptions view;
    std::optional<std::string> view_size;
    RenderOptions render;
    ConvertOptions convert;
    ExplainOptions explain;
    DoctorOptions doctor;
    std::string pixel;
    bool no_certify = false;
    std::string size = "1000x1000";
    std::optional<std::string> samples;
    std::optional<std::string> background;
    std::optional<std::string> shading;
    std::optional<std::string> backend;
    std::optional<std::string> device;
    std::optional<std::string> to;
    std::optional<std::string> frame;
    std::optional<std::string> radius;
    bool fit = false;
    bool no_fit = false;
    std::optional<std::string> view_from;
    std::optional<std::string> timeout;
};

// The options of one command; checked_render also reads SPHEREVIEW_BACKEND. All throw WrongUsage.
ViewOptions checked_view(const TypedOptions& typed);
RenderOptions checked_render(const TypedOptions& typed);
ConvertOptions checked_convert(const TypedOptions& typed);
ExplainOptions checked_explain(const TypedOptions& typed);
DoctorOptions checked_doctor(const TypedOptions& typed);

}  // namespace sphereview

#include "app/load_scene.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/memory.hpp"
#include "base/path.hpp"
#include "base/standard_streams.hpp"
#include "base/text.hpp"
#include "formats/atoms.hpp"
#include "formats/frame_reader.hpp"

namespace sphereview {

namespace {

// Whether a later frame of a long text is wanted, or a text that does not fit in memory may have several.
bool is_read_by_frames(const InputStream& stream, const SceneFormat& format, const DataOptions& wanted) {
    if (format.step_over == nullptr || !stream.is_regular()) return false;
    if (wanted.frame > 0) return !stream.size() || *stream.size() >= usual_index_from;
    const auto memory = available_memory();
    return stream.size() && memory && *stream.size() > *memory / 2;
}

// As SceneFormat::read, with only a part of the text in memory; goes no farther than it takes to count `enough` frames.
SphereData read_frame(FrameReader& reader, const LoadOptions& options, std::int64_t enough) {
    if (options.control != nullptr) options.control->total = std::filesystem::file_size(path_from(reader.name()));
    reader.watch([&options](double part) {
        if (options.progress != nullptr) options.progress->update(part);
        if (options.control == nullptr) return;
        options.control->done = static_cast<std::uint64_t>(part * static_cast<double>(options.control->total));
        options.control->check();
    });
    SphereData data = reader.read(options.data.frame);
    data.frames = reader.count(enough);
    if (!reader.fault().empty()) data.warnings.push_back(early_end(reader.fault(), data.frames));
    return data;
}

LoadedScene read_scene(const std::string& path, const LoadOptions& options) {
    InputStream stream(path);
    if (WorkControl* control = options.control) {
        control->check();  // a pipe may have opened late: what comes then is for the reading that replaced this one
        control->total = stream.size().value_or(0);
        stream.watch([control](std::size_t bytes) {
            control->done = bytes;
            control->check();
        });
    }
    Progress* progress = options.progress;
    if (progress != nullptr) progress->start(stream.name(), 1e-6 * static_cast<double>(stream.size().value_or(0)), "MB");
    LoadedScene loaded;
    loaded.name = stream.name();
    loaded.format = format_of_stream(stream, options.data);
    if (!loaded.format.has_frames) require_frame(loaded.name, options.data.frame, 1);
    if (loaded.format.stream != nullptr) {
        loaded.scene = loaded.format.stream(stream, sizeof(Sphere) + options.more_per_sphere, progress);
        return loaded;
    }
    const DataOptions wanted = with_properties(options.data, options.look);
    SphereData data;
    if (is_read_by_frames(stream, loaded.format, wanted)) {
        FrameReader reader(path, wanted);
        data = read_frame(reader, options, FrameReader::most_frames);
    } else {
        stream.fill();
        if (options.control != nullptr) options.control->check();
        data = loaded.format.read(stream.bytes(), loaded.name, wanted);
    }
    const std::size_t count = data.scene.spheres.size();
    require_memory_for_spheres(loaded.name, count, options.more_per_sphere);
    return {std::move(data), loaded.name, loaded.format};
}

// Of files that take a moment to go through.
constexpr std::uintmax_t least_size_to_stop_in = std::uintmax_t{16} << 20U;

bool is_large(const std::string& path) {
    std::error_code error;
    return path != standard_stream && std::filesystem::is_regular_file(path_from(path), error) &&
           std::filesystem::file_size(path_from(path), error) >= least_size_to_stop_in;
}

// Goes no farther than it takes to see whether there is another frame behind. Nothing where the format does not step over frames.
std::optional<LoadedScene> read_up_to_frame(const std::string& path, const LoadOptions& options) {
    FrameReader reader(path, with_properties(options.data, options.look));
    if (reader.format().step_over == nullptr) return std::nullopt;
    const std::int64_t enough = options.data.frame + 2;
    LoadedScene loaded{read_frame(reader, options, enough), reader.name(), reader.format()};
    loaded.all_frames = loaded.frames < enough;
    return loaded;
}

}  // namespace

std::optional<FitOptions> fit_from(const std::string& view) {
    if (const auto axes = parse_view(view)) return FitOptions{true, axes, {}, {}, {}, {}};
    return view_name_fault(view).empty() ? std::optional(FitOptions{{}, {}, {}, view, {}, {}}) : std::nullopt;
}

Camera saved_view(const LoadedScene& loaded, const std::string& name) {
    const std::vector<SavedView>& views = loaded.scene.views;
    const auto view = std::ranges::find(views, name, &SavedView::name);
    if (view != views.end()) return view->camera;
    std::vector<std::string> candidates(view_sides.begin(), view_sides.end());
    std::vector<std::string> saved;
    for (const SavedView& one : views) {
        candidates.push_back(one.name);
        saved.push_back(in_quotes(one.name));
    }
    constexpr std::size_t most_listed = 10;
    saved = first_of(std::move(saved), most_listed);
    throw InputError(loaded.name + ": found no view " + in_quotes(name) + ", expected " +
                     (saved.empty() ? std::string(view_syntax) + "; it has no saved views"
                                    : "one of its saved views, " + joined(saved, ", ") + ", or " + std::string(view_syntax)) +
                     did_you_mean(name, candidates));
}

Camera chosen_camera(const LoadedScene& loaded, const FitOptions& fit) {
    if (fit.given) return *fit.given;
    Camera camera = loaded.scene.camera;
    if (fit.camera) {
        const LoadedScene other = load_scene(*fit.camera);
        if (!other.has_camera() || other.format.holds_only_spheres) {
            throw InputError(other.name + ": found " + std::string(other.format.name) +
                             ", which has no camera; expected a scene in TOML");
        }
        camera = fit.saved_view ? saved_view(other, *fit.saved_view) : other.scene.camera;
    } else if (fit.saved_view) {
        camera = saved_view(loaded, *fit.saved_view);
    }
    if (fit.projection) camera.projection = *fit.projection;
    return camera;
}

bool is_to_fit(const LoadedScene& loaded, const FitOptions& fit) {
    if (fit.saved_view || fit.camera || fit.given) return false;
    return fit.wanted.value_or(!loaded.has_camera());
}

LoadedScene load_scene(const std::string& path, const LoadOptions& options) {
    std::optional<LoadedScene> part;
    if (!options.counts_frames && is_large(path)) part = read_up_to_frame(path, options);
    LoadedScene loaded = part ? std::move(*part) : read_scene(path, options);
    if (options.control != nullptr) options.control->check();
    complete(loaded, options);
    return loaded;
}

void complete(LoadedScene& loaded, const LoadOptions& options) {
    if (loaded.format.is_data && options.data_background) loaded.scene.background = *options.data_background;
    // Before the camera is fitted: radii count.
    if (options.look.any()) loaded.look = apply_look(loaded.scene, options.look, loaded.name, loaded.property_names);
    const FitOptions& fit = options.fit;
    Camera& camera = loaded.scene.camera;
    camera = chosen_camera(loaded, fit);
    if (!is_to_fit(loaded, fit)) return;
    const ViewAxes present = loaded.has_camera() ? axes_of(camera) : data_axes;
    camera = fitted(loaded.scene, with_hand_of(present, fit.view.value_or(present)), camera.projection).value_or(camera);
    loaded.fitted = true;
}

void require_properties(const LoadedScene& loaded, const DataOptions& asked) {
    for (const std::string& name : asked.properties) {
        const auto is_it = [&](const Property& property) { return lower_case(property.name) == lower_case(name); };
        if (std::ranges::any_of(loaded.scene.properties, is_it)) continue;
        constexpr std::size_t most_listed = 20;
        std::vector<std::string> has;
        for (const std::string& one : loaded.property_names) has.push_back(in_quotes(one));
        throw InputError(loaded.name + ": found no property " + in_quotes(name) + ", expected " +
                         (has.empty() ? "none: the file has no properties" : "one of " + joined(first_of(has, most_listed), ", ")) +
                         did_you_mean(name, loaded.property_names));
    }
}

void say_warnings(const LoadedScene& loaded) {
    for (const std::string& warning : loaded.warnings) say(warning);
    for (const std::string& line : loaded.look.lines) say(line);
}

}  // namespace sphereview

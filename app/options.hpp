// The commands and their options. Each command returns the exit status, or throws before it has done anything.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/failure.hpp"
#include "app/film_options.hpp"
#include "app/frame_ranges.hpp"
#include "app/light_options.hpp"
#include "app/load_scene.hpp"
#include "base/output_file.hpp"
#include "formats/scene_format.hpp"
#include "scene/scene.hpp"
#include "shade/shading.hpp"

namespace sphereview {

// The renderers that a person can ask for.
enum class Backend { automatic, egl, osmesa, wgl, cpu };

// By the values of Backend.
inline constexpr std::array<std::string_view, 5> backend_names = {"auto", "egl", "osmesa", "wgl", "cpu"};

constexpr std::string_view name_of(Backend backend) { return backend_names[static_cast<std::size_t>(backend)]; }

struct RenderOptions {
    std::vector<std::string> scenes;    // paths, or "-"
    std::optional<std::string> output;  // a path, a pattern with {name}, or "-"
    PictureSize size;
    int samples = 1;  // points a pixel: one of sample_counts
    DataOptions data;
    FitOptions fit;
    FrameOptions frames;                   // several pictures of a scene
    FilmOptions film;                      // made of them
    std::vector<std::string> words;        // the options of the command line that say what pictures look like
    std::optional<Background> background;  // instead of the scene's own
    Shading shading = Shading::flat;
    LightOptions light;  // instead of the scene's own
    LookOptions look{};
    bool axes = false;  // drawn in a corner
    bool scale_bar = false;
    bool legend = false;
    Backend backend = Backend::automatic;
    std::optional<int> device;          // an EGL device
    std::optional<std::string> expect;  // a golden image, may hold {name}
    std::optional<std::string> diff;    // where the picture of the difference goes, may hold {name}
    bool certify = true;
    Durability durability = Durability::on_disk;  // of pictures
    bool timings = false;
    bool json = false;
    bool verbose = false;

    // Whether the pictures are a film on standard output.
    bool streams_film() const { return frames.several() && output == standard_stream; }
};

struct ConvertOptions {
    std::string input;
    std::string output;
    std::optional<SceneFormat> to;  // by the output's name when not given
    DataOptions data;
    LookOptions look{};
    FitOptions fit;  // of the camera that is written
    bool verbose = false;
};

struct ExplainOptions {
    std::string scene;  // a path, or "-"
    Pixel pixel;        // inside the picture
    PictureSize size;
    DataOptions data;
    LookOptions look{};
    FitOptions fit;
    std::optional<Background> background;  // instead of the scene's own
    Shading shading = Shading::flat;
    LightOptions light;                  // instead of the scene's own
    std::optional<int> light_to_show{};  // one of NumberedLights, besides the one that is explained anyway
    bool json = false;
};

struct CompareOptions {
    std::vector<std::string> pictures;  // paths, one of which may be "-"
    std::string scene;                  // a path, or "-"
    DataOptions data;
    LookOptions look{};
    FitOptions fit;
    std::optional<Background> background;   // instead of the scene's own
    std::optional<std::string> difference;  // where its picture goes, may hold {name}
    bool writes_difference = true;
    bool json = false;
};

// How many of some pictures.
struct SampleSize {
    double number = 100.0;
    bool is_percent = true;
};

struct VerifyOptions {
    std::vector<std::string> manifests;  // paths: those of parts together have all pictures
    SampleSize sample;
    std::optional<Backend> backend;  // instead of the one that the pictures are from
    // The options of `render` for a scene, of the words that a manifest has. Throws InputError.
    RenderOptions (*parse_render)(const std::string& scene, const std::vector<std::string>& words,
                                  const std::string& where) = nullptr;
};

struct DoctorOptions {
    bool json = false;
    double timeout_seconds = 20.0;     // for each probe
    std::optional<std::string> probe;  // that one alone, for another process of the program
};

// What the program says of itself.
struct ProgramTexts {
    std::string name_and_version = "sphereview";
    std::string (*licenses)() = nullptr;  // a long text
};

struct ViewOptions {
    std::optional<std::string> scene;  // a path, or "-"; none: an empty scene
    DataOptions data;                  // of the scene; its radius of every one that is opened
    LookOptions look{};                // of the scene
    FitOptions fit;                    // of the scene; of later ones, if nobody has chosen their camera
    std::optional<Background> background;
    std::optional<Shading> shading;   // instead of the last one
    LightOptions light;               // instead of the scene's own
    std::optional<PictureSize> size;  // of exports, instead of the last ones
    std::optional<int> samples;       // instead of the last
    std::string shader_folder;        // instead of the shaders in the program; "" for those
    std::string redraw_log;           // hidden: a JSON line for each redraw goes there
    ProgramTexts program{};           // for Help > About
};

ExitCode run_view(const ViewOptions& options);  // in app/viewer/
ExitCode run_render(const RenderOptions& options);
ExitCode run_convert(const ConvertOptions& options);
ExitCode run_explain(const ExplainOptions& options);
ExitCode run_compare(const CompareOptions& options);
ExitCode run_verify(const VerifyOptions& options);
ExitCode run_doctor(const DoctorOptions& options);

// What run_explain() writes, of a scene that is read already; `name`: how the text calls the scene.
std::string explain(const Scene& scene, const std::string& name, const ExplainOptions& options);

}  // namespace sphereview

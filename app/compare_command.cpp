// sphereview compare: what is wrong in the pictures of somebody's own ray tracer.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/compare_words.hpp"
#include "app/json.hpp"
#include "app/load_scene.hpp"
#include "app/options.hpp"
#include "app/render_plan.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/path.hpp"
#include "base/standard_streams.hpp"
#include "base/text.hpp"
#include "exact/explain.hpp"
#include "image/picture_file.hpp"
#include "image/png.hpp"
#include "mistakes/diagnosis.hpp"

namespace sphereview {

namespace {

struct CompareJob {
    std::string picture;
    std::string difference;  // where its picture goes; "" for nowhere
    MissingFolder missing;   // of the difference
};

// How the folder of a file is called.
std::string folder_in_patterns(const std::string& path) {
    return text_from(std::filesystem::absolute(path_from(path)).parent_path().filename());
}

std::string fill_in_names(std::string_view pattern, const std::string& picture) {
    return fill_in(pattern, {.name = name_in_patterns(picture), .folder = folder_in_patterns(picture)});
}

// A pattern that would give each picture a file of its own.
std::string advice(const std::vector<std::string>& pictures) {
    for (const char* pattern : {"out/{name}.png", "out/{folder}-{name}.png"}) {
        std::set<std::string> names;
        const auto is_new = [&](const std::string& picture) { return names.insert(fill_in_names(pattern, picture)).second; };
        if (std::ranges::all_of(pictures, is_new)) return std::string("use --diff with a pattern such as ") + pattern;
    }
    return "compare those of one name one at a time";
}

// One job a picture. Throws InputError where a difference would overwrite a picture, the scene or another difference.
std::vector<CompareJob> plan(const CompareOptions& options) {
    std::set<std::string> taken;
    taken.insert(file_identity(options.scene, FileUse::input));
    for (const std::string& picture : options.pictures) taken.insert(file_identity(picture, FileUse::input));
    std::vector<CompareJob> jobs;
    const std::string pattern = png_name(options.difference.value_or("{name}-difference"));
    for (const std::string& picture : options.pictures) {
        const bool is_pattern = fill_in(pattern, {.folder = ""}) != pattern;
        CompareJob job{picture, "", is_pattern ? MissingFolder::made : missing_folder(pattern)};
        if (options.writes_difference) {
            job.difference = fill_in_names(pattern, picture);
            check_output(job.difference, job.missing);
            const std::string file = file_identity(job.difference, FileUse::output);
            if (!file.empty() && !taken.insert(file).second) {
                throw InputError(job.difference + ": the picture of the difference of " + picture +
                                 " would overwrite another file of these; " + advice(options.pictures));
            }
        }
        jobs.push_back(std::move(job));
    }
    return jobs;
}

std::string coordinates(Pixel pixel) { return std::to_string(pixel.x) + "," + std::to_string(pixel.y); }

// The roots of a sphere along a pixel's ray, or that it has none.
std::string roots_in_words(const Scene& scene, const PixelExplanation& explanation, std::int32_t number) {
    for (const ExplainedHit& hit : explanation.hits) {
        if (hit.number != number) continue;
        const HitInWords words = in_words(hit);
        return called(scene, number) + ": t1 = " + words.t1 + ", t2 = " + words.t2;
    }
    return called(scene, number) + ": no hit in front of the eye";
}

// A line for each thing that a person should know of the pictures, in the order in which it helps.
// `explain`: the beginning of a command that says more of a pixel; "" where none would explain the same picture.
std::string in_words(const Diagnosis& diagnosis, const CompareJob& job, const LoadedScene& loaded, PictureSize size,
                     const std::string& explain) {
    const std::string name = on_one_line(job.picture);
    const std::string scene_name = on_one_line(loaded.name);
    const auto count = [](std::int64_t pixels) { return in_groups(static_cast<std::uint64_t>(pixels)); };
    if (diagnosis.different == 0) return name + ": equal to the right picture of " + scene_name + "\n";
    const std::string differing = count(diagnosis.different) + " of " + count(diagnosis.pixels) +
                                  " pixels differ from the right picture of " + scene_name + "\n";
    std::string text = name + ": ";
    if (!diagnosis.style.empty()) {
        text += diagnosis.style_words + "\n  " + differing;
    } else {
        text += differing;
        for (const std::string& line : verdict_in_words(diagnosis)) {
            text += (line.starts_with("likeliest") ? "  " : "    ") + line + "\n";
        }
    }
    const bool said = diagnosis.shares.size() == 1 && !diagnosis.likeliest.empty();
    for (const MistakeShare& share : said ? std::vector<MistakeShare>{} : diagnosis.shares)
        text += "  " + count(share.pixels) + ": " + share.words + "\n";
    const DrawnSpheres drawn = drawn_spheres(loaded.scene);
    for (const DifferingPixel& example : diagnosis.examples) {
        text += "  " + in_words(loaded.scene, example) + "\n";
        const PixelExplanation explanation = explain_pixel(loaded.scene, drawn, loaded.scene.camera, size, example.pixel);
        for (const std::int32_t number : {example.expected_number, example.found_number.value_or(visible_background)}) {
            if (number != visible_background) text += "    " + roots_in_words(loaded.scene, explanation, number) + "\n";
        }
        if (explain.empty()) continue;
        text += "    more: " + explain + " --pixel " + coordinates(example.pixel) + " --size " + std::to_string(size.width) + "x" +
                std::to_string(size.height) + "\n";
    }
    if (!job.difference.empty()) text += "  picture of the difference: " + on_one_line(job.difference) + "\n";
    return text;
}

Json number_or_null(std::int32_t number) { return number == visible_background ? Json(nullptr) : Json(number); }

Json to_json(const Diagnosis& diagnosis, const CompareJob& job, const LoadedScene& loaded, PictureSize size) {
    Json shares = Json::array();
    for (const MistakeShare& share : diagnosis.shares) {
        shares.push_back({{"name", share.name}, {"words", share.words}, {"pixels", share.pixels}, {"mark", rgb(share.mark)}});
    }
    Json examples = Json::array();
    for (const DifferingPixel& example : diagnosis.examples) {
        examples.push_back({{"pixel", {example.pixel.x, example.pixel.y}},
                            {"found", rgb(example.found)},
                            {"found_known", example.found_number.has_value()},
                            {"found_sphere", number_or_null(example.found_number.value_or(visible_background))},
                            {"expected", rgb(example.expected)},
                            {"expected_sphere", number_or_null(example.expected_number)},
                            {"mistake", diagnosis.shares[example.share].name}});
    }
    const bool equal = diagnosis.different == 0;
    return {{"picture", job.picture},
            {"scene", loaded.name},
            {"status", static_cast<int>(equal ? ExitCode::done : ExitCode::differs)},
            {"error", nullptr},
            {"size", {size.width, size.height}},
            {"equal", equal},
            {"different_pixels", diagnosis.different},
            {"likeliest", diagnosis.likeliest},
            {"likeliest_words", diagnosis.likeliest_words},
            {"style", diagnosis.style.empty() ? Json(nullptr) : Json(diagnosis.style)},
            {"style_words", diagnosis.style_words},
            {"explained", diagnosis.explained},
            {"contradicting", diagnosis.contradicting},
            {"as_likely", diagnosis.as_likely},
            {"mistakes", shares},
            {"examples", examples},
            {"difference", equal || job.difference.empty() ? Json(nullptr) : Json(job.difference)}};
}

// Compares pictures with one scene. What wrong tracers see of it is made once for pictures of one size.
class Comparing {
public:
    Comparing(const CompareOptions& options, const LoadedScene& loaded) : options_(options), loaded_(loaded) {}

    ExitCode run(const CompareJob& job) {
        try {
            const Image picture = read_picture(job.picture);
            const PictureSize size{picture.width(), picture.height()};
            if (wrong_ == nullptr || wrong_->size() != size) {
                wrong_.reset();
                wrong_ = std::make_unique<WrongPictures>(loaded_.scene, size);
            }
            wrong_->forget_combinations();
            const Background background = options_.background.value_or(loaded_.scene.background);
            Image marked;
            const Diagnosis diagnosis =
                diagnose(picture, loaded_.scene, background, *wrong_, job.difference.empty() ? nullptr : &marked);
            const bool equal = diagnosis.different == 0;
            if (!equal && !job.difference.empty())
                write_output(job.difference, encode_png(marked), Durability::on_disk, job.missing);
            report(options_.json ? to_json(diagnosis, job, loaded_, size).dump() + "\n"
                                 : in_words(diagnosis, job, loaded_, size, explain_command()));
            return equal ? ExitCode::done : ExitCode::differs;
        } catch (...) {
            const Failure failure = describe_current_exception(job.picture);
            say(failure.message);
            if (options_.json) {
                report(Json{{"picture", job.picture},
                            {"scene", loaded_.name},
                            {"status", static_cast<int>(failure.code)},
                            {"error", failure.message}}
                           .dump() +
                       "\n");
            }
            return failure.code;
        }
    }

private:
    // For a scene by its own name and camera: of a name with other characters the shell might make something else.
    std::string explain_command() const {
        const FitOptions& fit = options_.fit;
        const bool usual = !fit.wanted && !fit.view && !fit.projection && !fit.saved_view && options_.data.frame == 0 &&
                           !options_.data.radius && options_.data.columns.empty() && !options_.look.any() && !options_.background &&
                           options_.scene != standard_stream;
        const auto is_plain = [](unsigned char c) {
            return std::isalnum(c) != 0 || std::string_view("._/+-").find(static_cast<char>(c)) != std::string_view::npos;
        };
        return usual && std::ranges::all_of(options_.scene, is_plain) ? "sphereview explain " + options_.scene : "";
    }

    static void report(const std::string& text) { write_output(std::string(standard_stream), text); }

    const CompareOptions& options_;
    const LoadedScene& loaded_;
    std::unique_ptr<WrongPictures> wrong_{};
};

}  // namespace

ExitCode run_compare(const CompareOptions& options) {
    const std::vector<CompareJob> jobs = plan(options);
    const LoadedScene loaded = load_scene(options.scene, {.data = options.data, .look = options.look, .fit = options.fit});
    say_warnings(loaded);
    Comparing comparing(options, loaded);
    ExitCode worst = ExitCode::done;
    for (const CompareJob& job : jobs) worst = std::max(worst, comparing.run(job));
    return worst;
}

}  // namespace sphereview

#include "app/render_plan.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "app/frame_sequence.hpp"
#include "base/error.hpp"
#include "base/gunzip.hpp"
#include "base/input_file.hpp"
#include "base/path.hpp"
#include "base/text.hpp"
#include "image/png.hpp"

namespace sphereview {

namespace {

constexpr std::string_view placeholder = "{name}";
constexpr std::string_view folder_placeholder = "{folder}";

constexpr std::string_view frame_placeholder = "{frame";
constexpr std::size_t most_digits = 18;

// How many characters at the beginning of `text` are a placeholder of a frame, and with how many digits; 0 where it is none.
struct FramePlaceholder {
    std::size_t length = 0;
    std::size_t digits = 1;
};

FramePlaceholder frame_placeholder_at(std::string_view text) {
    const std::size_t end = text.find('}');
    if (!text.starts_with(frame_placeholder) || end == std::string_view::npos) return {};
    const std::string_view format = text.substr(0, end).substr(frame_placeholder.size());
    if (format.empty()) return {end + 1, 1};
    std::size_t digits = 0;
    if (!format.starts_with(":0") || !parse_whole(format.substr(2), digits) || digits < 1 || digits > most_digits) return {};
    return {end + 1, digits};
}

// Throws InputError for what looks like a placeholder of numbers and is none.
void require_placeholders(const std::string& pattern, const std::string& option) {
    for (std::size_t at = pattern.find(frame_placeholder); at != std::string::npos; at = pattern.find(frame_placeholder, at + 1)) {
        const std::string_view rest = std::string_view(pattern).substr(at);
        if (frame_placeholder_at(rest).length > 0) continue;
        throw InputError(
            "sphereview: " + option + ": found " + in_quotes(rest.substr(0, std::min(rest.find('}'), rest.size() - 1) + 1)) +
            ", expected {frame}, or {frame:0N} with N from 1 to " + std::to_string(most_digits) + " for so many digits");
    }
}

// Names of several pictures must have their numbers.
std::string usual_output(const RenderOptions& options) {
    return std::string(placeholder) + (options.frames.several() ? "-{frame:05}" : "");
}

void name_files(RenderJob& job, std::int64_t number, const RenderOptions& options, const std::string& output,
                const std::optional<std::string>& diff) {
    const auto filled = [&](const std::string& pattern) { return fill_in(pattern, {.name = job.name, .frame = number}); };
    const bool is_written = options.output ? !options.streams_film() : !options.expect && !options.film.movie;
    if (is_written) job.output = filled(output);
    if (options.expect) job.expect = filled(*options.expect);
    if (diff) job.diff = filled(*diff);
}

// Remembers what each file and standard stream is used for, and refuses a use that would destroy another.
class FileUses {
public:
    // by_name: outputs that have the same name are one file, and others are not looked for: on a cluster's disk that takes long.
    explicit FileUses(bool by_name = false) : by_name_(by_name) {}

    void read(const std::string& path, const std::string& as) {
        if (path == standard_stream) {
            if (!stdin_use_.empty()) throw InputError("sphereview: stdin cannot be both " + stdin_use_ + " and " + as);
            stdin_use_ = as;
        } else if (const std::string file = file_identity(path, FileUse::input); !file.empty()) {
            inputs_.emplace(file, as);
        }
    }

    void write_stdout(const std::string& as) {
        if (!stdout_use_.empty()) throw InputError("sphereview: stdout cannot be both " + stdout_use_ + " and " + as);
        stdout_use_ = as;
    }

    // `path` is `pattern` with the job's name filled in; of all jobs: null.
    void write(const std::string& path, const std::string& as, const RenderJob* job, const std::string& pattern) {
        if (path == standard_stream) return write_stdout(as);
        const std::string file = by_name_ ? path : file_identity(path, FileUse::output);
        if (file.empty()) return;
        if (const auto input = inputs_.find(file); input != inputs_.end()) {
            throw InputError(path + ": cannot be both " + as + " and " + input->second);
        }
        const auto [other, added] = outputs_.emplace(file, Output{as, job});
        if (!added && file_identity(path, FileUse::output) != "")
            throw InputError(path + ": cannot be both " + as + " and " + other->second.as +
                             advice(other->second.job, job, pattern));
    }

private:
    struct Output {
        std::string as;
        const RenderJob* job;
    };

    static std::int64_t number_of(const RenderJob& job) { return job.sequence->shots()[job.shot].number; }

    static std::string advice(const RenderJob* first, const RenderJob* second, const std::string& pattern) {
        if (first == second || first == nullptr || second == nullptr) return "; they need two names";
        if (first->sequence && first->sequence == second->sequence) {
            const bool has_number = pattern.find(frame_placeholder) != std::string::npos;
            return has_number ? "; frame " + std::to_string(number_of(*second)) + " is named twice"
                              : "; use {frame} for each picture's number";
        }
        if (first->name == second->name)
            return "; both scenes are called " + in_quotes(first->name) + ": render them one at a time";
        return pattern.find(placeholder) == std::string::npos ? "; use {name} for each scene's own name"
                                                              : "; choose another pattern";
    }

    bool by_name_;
    std::map<std::string, std::string> inputs_;
    std::map<std::string, Output> outputs_;
    std::string stdin_use_;
    std::string stdout_use_;
};

}  // namespace

std::string fill_in(std::string_view pattern, const PatternValues& values) {
    std::string filled;
    while (!pattern.empty()) {
        std::size_t length = 0;
        if (values.name && pattern.starts_with(placeholder)) {
            filled += *values.name;
            length = placeholder.size();
        } else if (values.folder && pattern.starts_with(folder_placeholder)) {
            filled += *values.folder;
            length = folder_placeholder.size();
        } else if (const FramePlaceholder found = frame_placeholder_at(pattern); values.frame && found.length > 0) {
            const std::string digits = std::to_string(*values.frame);
            filled += std::string(found.digits - std::min(found.digits, digits.size()), '0') + digits;
            length = found.length;
        } else {
            length = std::min(pattern.find('{', 1), pattern.size());
            filled += pattern.substr(0, length);
        }
        pattern.remove_prefix(length);
    }
    return filled;
}

bool has_frame(std::string_view pattern) { return fill_in(pattern, {.frame = 0}) != pattern; }

MissingFolder missing_folder(const std::string& pattern) {
    const bool is_pattern = pattern.find(placeholder) != std::string::npos || has_frame(pattern);
    return is_pattern ? MissingFolder::made : MissingFolder::refused;
}

std::string name_in_patterns(const std::string& path) {
    if (path == standard_stream) return "stdin";
    return text_from(path_from(without_gzip_ending(path)).stem());
}

RenderJob job_of_scene(const std::string& scene, const std::string& fault) {
    RenderJob job;
    job.scene = scene;
    job.label = job.scene_label = scene == standard_stream ? "stdin" : scene;
    job.name = name_in_patterns(scene);
    job.fault = fault;
    return job;
}

std::size_t count_pictures(std::span<const RenderJob> jobs) {
    return static_cast<std::size_t>(std::ranges::count_if(jobs, [](const RenderJob& job) { return job.fault.empty(); }));
}

std::vector<RenderJob> plan_render(const RenderOptions& options, std::span<const OpenedScene> opened) {
    // Of the patterns, since a scene's own name may hold dots.
    const std::string output = png_name(options.output.value_or(usual_output(options)));
    const std::optional<std::string> diff = options.diff ? std::optional(png_name(*options.diff)) : std::nullopt;
    if (options.frames.several()) {
        require_placeholders(output, "--output");
        require_placeholders(options.expect.value_or(""), "--expect");
        require_placeholders(diff.value_or(""), "--diff");
    }
    FileUses uses;
    if (options.fit.camera) uses.read(*options.fit.camera, "the scene of the camera");
    std::vector<RenderJob> jobs;
    for (std::size_t i = 0; i < options.scenes.size(); ++i) {
        RenderJob job = job_of_scene(options.scenes[i], opened.empty() ? "" : opened[i].fault);
        uses.read(job.scene, "the scene " + job.label);
        if (opened.empty() || !opened[i].sequence) {
            if (job.fault.empty()) name_files(job, options.data.frame, options, output, diff);
            jobs.push_back(job);
            continue;
        }
        job.sequence = opened[i].sequence;
        for (job.shot = 0; job.shot < job.sequence->shots().size(); ++job.shot) {
            const std::int64_t number = job.sequence->shots()[job.shot].number;
            job.label = job.scene_label + ", " + std::to_string(number);
            name_files(job, number, options, output, diff);
            jobs.push_back(job);
        }
    }

    const auto use_outputs = [&](FileUses& of) {
        for (const RenderJob& job : jobs) {
            if (job.output) of.write(*job.output, "the picture of " + job.label, &job, output);
            if (job.diff) of.write(*job.diff, "the difference picture of " + job.label, &job, *diff);
        }
    };
    if (const auto& part = options.frames.part) {
        FileUses of_all_parts(true);
        use_outputs(of_all_parts);
        std::size_t place = 0;
        std::erase_if(jobs, [&](const RenderJob&) { return !part->has(place++); });
    }
    for (const RenderJob& job : jobs) {
        if (job.expect) uses.read(*job.expect, "the expected picture of " + job.label);
    }
    if (options.json) uses.write_stdout("the JSON report");
    if (options.streams_film()) uses.write_stdout("the film");
    if (options.film.movie) uses.write(*options.film.movie, "the film", nullptr, *options.film.movie);
    if (options.frames.manifest) uses.write(*options.frames.manifest, "the manifest", nullptr, *options.frames.manifest);
    use_outputs(uses);
    return jobs;
}

}  // namespace sphereview

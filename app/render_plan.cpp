#include "app/render_plan.hpp"

#include <filesystem>
#include <map>

#include "base/error.hpp"
#include "base/gunzip.hpp"
#include "base/input_file.hpp"
#include "base/path.hpp"
#include "base/text.hpp"
#include "image/png.hpp"

namespace sphereview {

namespace {

constexpr std::string_view placeholder = "{name}";

std::optional<std::string> filled_in(const std::optional<std::string>& pattern, const std::string& name) {
    return pattern ? std::optional(fill_in(*pattern, name)) : std::nullopt;
}

// Remembers what each file and standard stream is used for, and refuses a use that would destroy another.
class FileUses {
public:
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

    // `path` is `pattern` with the job's name filled in.
    void write(const std::string& path, const std::string& as, const RenderJob& job, const std::string& pattern) {
        if (path == standard_stream) return write_stdout(as);
        const std::string file = file_identity(path, FileUse::output);
        if (file.empty()) return;
        if (const auto input = inputs_.find(file); input != inputs_.end()) {
            throw InputError(path + ": cannot be both " + as + " and " + input->second);
        }
        const auto [other, added] = outputs_.emplace(file, Output{as, &job});
        if (!added)
            throw InputError(path + ": cannot be both " + as + " and " + other->second.as +
                             advice(*other->second.job, job, pattern));
    }

private:
    struct Output {
        std::string as;
        const RenderJob* job;
    };

    static std::string advice(const RenderJob& first, const RenderJob& second, const std::string& pattern) {
        if (&first == &second) return "; they need two names";
        if (first.name == second.name) return "; both scenes are called " + in_quotes(first.name) + ": render them one at a time";
        return pattern.find(placeholder) == std::string::npos ? "; use {name} for each scene's own name"
                                                              : "; choose another pattern";
    }

    std::map<std::string, std::string> inputs_;
    std::map<std::string, Output> outputs_;
    std::string stdin_use_;
    std::string stdout_use_;
};

}  // namespace

std::string fill_in(std::string pattern, const std::string& name) {
    for (std::size_t at = 0; (at = pattern.find(placeholder, at)) != std::string::npos; at += name.size()) {
        pattern.replace(at, placeholder.size(), name);
    }
    return pattern;
}

MissingFolder missing_folder(const std::string& pattern) {
    return pattern.find(placeholder) == std::string::npos ? MissingFolder::refused : MissingFolder::made;
}

std::string name_in_patterns(const std::string& path) {
    if (path == standard_stream) return "stdin";
    return text_from(path_from(without_gzip_ending(path)).stem());
}

std::vector<RenderJob> plan_render(const RenderOptions& options) {
    // Of the patterns, since a scene's own name may hold dots.
    const std::string output = png_name(options.output.value_or(std::string(placeholder)));
    const std::optional<std::string> diff = options.diff ? std::optional(png_name(*options.diff)) : std::nullopt;
    std::vector<RenderJob> jobs;
    for (const std::string& scene : options.scenes) {
        RenderJob job;
        job.scene = scene;
        job.label = scene == standard_stream ? "stdin" : scene;
        job.name = name_in_patterns(scene);
        if (options.output || !options.expect) job.output = fill_in(output, job.name);
        job.expect = filled_in(options.expect, job.name);
        job.diff = filled_in(diff, job.name);
        jobs.push_back(job);
    }

    FileUses uses;
    for (const RenderJob& job : jobs) {
        uses.read(job.scene, "the scene " + job.label);
        if (job.expect) uses.read(*job.expect, "the expected picture of " + job.label);
    }
    if (options.json) uses.write_stdout("the JSON report");
    for (const RenderJob& job : jobs) {
        if (job.output) uses.write(*job.output, "the picture of " + job.label, job, output);
        if (job.diff) uses.write(*job.diff, "the difference picture of " + job.label, job, *diff);
    }
    return jobs;
}

}  // namespace sphereview

#include "app/manifest.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "app/frame_sequence.hpp"
#include "app/json.hpp"
#include "app/version.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/sha256.hpp"
#include "base/standard_streams.hpp"
#include "base/text.hpp"
#include "image/whole_png.hpp"

namespace sphereview {

namespace {

constexpr std::size_t read_at_once = std::size_t{1} << 22;

// No file's name and no option has a NUL; what follows one would be lost.
std::optional<std::string> text_of(const Json& json, std::string_view key, const std::string& place) {
    std::optional<std::string> text = json[key].text();
    if (text && text->find('\0') != std::string::npos) {
        throw InputError(place + "found a NUL in " + in_quotes(key) + ", expected a text without one");
    }
    return text;
}

std::string required_text(const Json& json, std::string_view key, const std::string& place) {
    if (auto text = text_of(json, key, place)) return *text;
    throw InputError(place + "found no " + in_quotes(key) + ", expected a line of a manifest");
}

std::int64_t required_number(const Json& json, std::string_view key, const std::string& place) {
    const auto number = json[key].whole();
    if (number && *number >= 0) return *number;
    throw InputError(place + "found no " + in_quotes(key) + " from 0, expected a line of a manifest");
}

ManifestEntry entry_of(std::string_view line, const std::string& name, std::size_t number) {
    const TextPosition begin{number, 1};
    const std::string place = place_in(name, begin);
    const Json json = Json::parse(line, name, begin);
    ManifestEntry entry;
    entry.where = place;
    entry.picture = text_of(json, "picture", place);
    entry.frame = required_number(json, "frame", place);
    entry.place = static_cast<std::size_t>(required_number(json, "place", place));
    entry.scene = required_text(json, "scene", place);
    entry.scene_sum = required_text(json, "scene_sha256", place);
    entry.camera_sum = json["camera_sha256"].text();
    entry.sequence_sum = json["sequence_sha256"].text();
    for (const Json& word : json["options"].list()) entry.options.push_back(word.text().value_or(""));
    entry.pixels_sum = required_text(json, "pixels_sha256", place);
    entry.file_sum = json["file_sha256"].text();
    entry.version = required_text(json, "version", place);
    return entry;
}

[[noreturn]] void refuse_irregular(const std::string& path) {
    throw InputError(path + ": found no regular file, expected one: a device may have no end");
}

// JSON holds no other name: nobody would find the file again.
void require_utf8(const std::string& word) {
    if (!is_utf8(word)) throw InputError("sphereview: --manifest: found " + in_quotes(word) + ", expected a name in UTF-8");
}

std::string_view whole_lines_of(std::string_view text) { return text.substr(0, text.rfind('\n') + 1); }

std::optional<std::string> sequence_sum(const RenderJob& job) {
    return job.sequence ? std::optional(job.sequence->sum_of(job.sequence->shots()[job.shot])) : std::nullopt;
}

std::vector<std::string> options_of_one(const std::vector<std::string>& options, bool of_sequence) {
    constexpr auto of_others = std::to_array<std::string_view>({"--frame", "--frames", "--turntable", "--axis"});
    if (!of_sequence) return options;
    std::vector<std::string> rest;
    for (std::size_t i = 0; i < options.size(); ++i) {
        if (std::ranges::find(of_others, options[i]) != of_others.end()) {
            ++i;  // its value
        } else {
            rest.push_back(options[i]);
        }
    }
    return rest;
}

std::vector<ManifestEntry> entries_of(std::string_view text, const std::string& name) {
    std::vector<ManifestEntry> entries;
    std::size_t number = 1;
    for (text = whole_lines_of(text); !text.empty(); ++number) {
        const std::string_view line = take_line(text);
        if (!trimmed(line).empty()) entries.push_back(entry_of(line, name, number));
    }
    return entries;
}

}  // namespace

std::string sum_of_pixels(const Image& picture) {
    const auto bytes = picture.bytes();
    return sha256(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void require_regular_file(const std::string& path) {
    // Not opened: a FIFO would be waited for.
    if (file_identity(path, FileUse::input).empty()) refuse_irregular(path);
}

std::string sum_of_file(const std::string& path) {
    require_regular_file(path);
    InputStream stream(path, Content::binary);
    stream.fill(1);
    const bool is_empty = stream.bytes().empty();
    if (!stream.is_regular() && !is_empty) refuse_irregular(path);  // it hides its size
    return sha256([&, first = true]() mutable {
        if (std::exchange(first, false)) return stream.bytes();
        stream.drop_first(stream.bytes().size());
        stream.fill(read_at_once);
        return stream.bytes();
    });
}

std::vector<std::string> options_of_one(const ManifestEntry& entry) {
    return options_of_one(entry.options, entry.sequence_sum.has_value());
}

ManifestLines read_manifest(const std::string& path) {
    const InputFile file(path);
    const std::string_view text = file.bytes();
    ManifestLines lines{entries_of(text, file.name())};
    if (whole_lines_of(text).size() < text.size()) lines.cut_off = position_at(text, text.size()).line;
    return lines;
}

std::map<std::string, FileStates> states_of_inputs(const RenderOptions& options) {
    std::map<std::string, FileStates> states;
    for (const std::string& scene : options.scenes) states.emplace(scene, file_states(scene));
    if (options.fit.camera) states.emplace(*options.fit.camera, file_states(*options.fit.camera));
    return states;
}

Manifest::Manifest(const RenderOptions& options, std::span<const RenderJob> jobs, std::map<std::string, FileStates> states)
    : options_(options), states_(std::move(states)), file_(nullptr, &std::fclose) {
    const std::string& path = *options.frames.manifest;
    for (const std::string& scene : options.scenes) {
        if (scene == standard_stream)
            throw InputError("sphereview: --manifest: found stdin as a scene, expected a file: it has a sum");
        require_utf8(scene);
    }
    if (options.fit.camera) require_regular_file(*options.fit.camera);
    for (const std::string& word : options.words) require_utf8(word);
    for (const RenderJob& job : jobs) require_utf8(job.output.value_or(""));
    std::string kept;
    if (options.frames.skip_existing && file_identity(path, FileUse::input) != "") {
        std::FILE* there = open_file(path, "rb");
        if (there != nullptr) {
            std::fclose(there);
            const InputFile file(path);
            kept = kept_of(whole_lines_of(file.bytes()), jobs);
        }
    }
    write_output(path, kept, Durability::on_disk, MissingFolder::made);
    file_.reset(open_file(path, "ab"));
    if (!file_) throw OutputError(path, std::strerror(errno), errno);
}

std::int64_t Manifest::number_of(const RenderJob& job) const {
    return job.sequence ? job.sequence->shots()[job.shot].number : options_.data.frame;
}

const std::string& Manifest::sum_of(const std::string& file) {
    const auto known = sums_.find(file);
    if (known != sums_.end()) return known->second;
    const std::string sum = sum_of_file(file);
    require_same(file);
    return sums_.emplace(file, sum).first->second;
}

std::optional<std::string> Manifest::camera_sum() {
    return options_.fit.camera ? std::optional(sum_of(*options_.fit.camera)) : std::nullopt;
}

void Manifest::require_same(const std::string& file) {
    if (file_states(file) == states_.at(file)) return;
    lost_scene_ = true;
    throw InputError(file + ": has changed since the run began, expected the same file to the end: no further picture has a line");
}

bool Manifest::is_of(const ManifestEntry& entry, const RenderJob& job) {
    if (states_.at(job.scene).empty()) return true;  // its own job says what is wrong with it
    return entry.frame == number_of(job) && entry.scene == job.scene && entry.scene_sum == sum_of(job.scene) &&
           entry.camera_sum == camera_sum() && entry.sequence_sum == sequence_sum(job) &&
           options_of_one(entry) == options_of_one(options_.words, job.sequence != nullptr);
}

std::string Manifest::kept_of(std::string_view lines, std::span<const RenderJob> jobs) {
    std::map<std::string, const RenderJob*> wanted;
    std::set<std::string> scenes(options_.scenes.begin(), options_.scenes.end());  // a part may have no picture of one
    for (const RenderJob& job : jobs) {
        if (job.output) wanted.emplace(*job.output, &job);
        if (!job.fault.empty() || states_.at(job.scene).empty()) scenes.erase(job.scene);
    }
    std::vector<std::string> kept;
    std::map<std::string, std::size_t> kept_at;
    for (const ManifestEntry& entry : entries_of(lines, *options_.frames.manifest)) {
        std::string_view line = take_line(lines);
        while (trimmed(line).empty()) line = take_line(lines);
        const std::string picture = entry.picture.value_or("");
        const auto job = wanted.find(picture);
        if (job == wanted.end()) {
            // Nobody can make it again, as where the file had more frames once.
            if (scenes.contains(entry.scene) && sum_of(entry.scene) != entry.scene_sum) continue;
        } else {
            if (!is_of(entry, *job->second)) {
                outdated_.insert(picture);
                continue;
            }
            // Of several lines the last one counts.
            const auto [at, is_first] = kept_at.emplace(picture, kept.size());
            if (!is_first) {
                kept[at->second] = line;
                continue;
            }
        }
        kept.emplace_back(line);
    }
    for (const auto& [picture, at] : kept_at) {
        outdated_.erase(picture);
        if (is_whole_png(picture, options_.size.width, options_.size.height)) {
            known_.insert(picture);
        } else {
            lines_of_lost_.insert(kept[at]);
        }
    }
    kept.emplace_back();
    return joined(kept, "\n");
}

void Manifest::add(const RenderJob& job, const PictureSums& sums) {
    require_same(job.scene);
    if (options_.fit.camera) require_same(*options_.fit.camera);
    const Json line = {{"frame", number_of(job)},
                       {"picture", job.output},
                       {"place", job.shot},
                       {"scene", job.scene},
                       {"scene_sha256", sum_of(job.scene)},
                       {"camera_sha256", camera_sum()},
                       {"sequence_sha256", sequence_sum(job)},
                       {"options", options_.words},
                       {"pixels_sha256", sums.pixels},
                       {"file_sha256", sums.file},
                       {"version", std::string(version)}};
    const std::string text = line.dump();
    if (lines_of_lost_.contains(text)) return;
    if (!append(file_.get(), text + "\n", options_.durability))
        throw OutputError(*options_.frames.manifest, errno != 0 ? std::strerror(errno) : "a write error", errno);
}

}  // namespace sphereview

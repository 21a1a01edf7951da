// sphereview verify: renders pictures of a manifest again.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "app/frame_sequence.hpp"
#include "app/manifest.hpp"
#include "app/options.hpp"
#include "app/render_jobs.hpp"
#include "app/version.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/standard_streams.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

auto all_of(const ManifestEntry& entry) {
    return std::tie(entry.scene, entry.place, entry.frame, entry.picture, entry.scene_sum, entry.camera_sum, entry.sequence_sum,
                    entry.options, entry.pixels_sum, entry.file_sum);
}

// A picture that has several lines, in one manifest or in several, counts once.
void leave_out_twins(std::vector<ManifestEntry>& entries) {
    using Entry = const ManifestEntry&;
    std::ranges::sort(entries, [](Entry one, Entry other) { return all_of(one) < all_of(other); });
    const auto are_equal = [](Entry one, Entry other) { return all_of(one) == all_of(other); };
    entries.erase(std::unique(entries.begin(), entries.end(), are_equal), entries.end());
}

// Spread evenly, from a random place on: who made the pictures cannot know which are looked at.
std::vector<ManifestEntry> sample_of(const std::vector<ManifestEntry>& entries, const SampleSize& size) {
    const auto all = static_cast<double>(entries.size());
    const double wanted = std::clamp(size.is_percent ? std::ceil(all * size.number / 100.0) : size.number, 1.0, all);
    const auto count = static_cast<std::size_t>(wanted);
    std::random_device random;
    const std::size_t begin = random() % entries.size();
    std::vector<ManifestEntry> sample;
    for (std::size_t i = 0; i < count; ++i) sample.push_back(entries[(begin + i * entries.size() / count) % entries.size()]);
    std::ranges::stable_sort(sample, {}, &ManifestEntry::place);
    return sample;
}

// Throws InputError where the file is not the one that the pictures were made of.
void require_sum(const std::string& file, const std::string& sum) {
    const std::string found = sum_of_file(file);
    if (found == sum) return;
    throw InputError(file + ": found another file than the pictures were made of: its SHA-256 is " + found + ", expected " + sum);
}

bool is_here(const std::string& file) {
    if (file_identity(file, FileUse::input).empty()) return true;  // not opened: a FIFO would be waited for
    std::FILE* there = open_file(file, "rb");
    if (there == nullptr) return false;
    std::fclose(there);
    return true;
}

// Whether the picture's file, if it is here, is as it was written: done, differs, or what it means that it cannot be read.
ExitCode state_of_file(const ManifestEntry& entry) {
    if (!entry.picture || !entry.file_sum || !is_here(*entry.picture)) return ExitCode::done;
    try {
        if (sum_of_file(*entry.picture) == *entry.file_sum) return ExitCode::done;
    } catch (const InputError& error) {  // the others are looked at
        say(error.what());
        return ExitCode::bad_input;
    }
    say(*entry.picture + ": the file differs from the one that was written");
    return ExitCode::differs;
}

// "3 of 10 pictures ARE: a, b and 1 more", or IS; nothing where there are none.
void say_which(const std::vector<std::string>& some, std::size_t all, const std::string& is, const std::string& are) {
    constexpr std::size_t most_named = 10;
    if (some.empty()) return;
    say(in_groups(some.size()) + " of " + in_groups(all) + " pictures " + (some.size() == 1 ? is : are) + ": " +
        joined(first_of(some, most_named), "; "));
}

// They may be elsewhere: that is no difference.
void say_which_are_not_here(const std::vector<ManifestEntry>& entries) {
    std::vector<std::string> missing;
    for (const ManifestEntry& entry : entries) {
        if (entry.picture && !is_here(*entry.picture)) missing.push_back(*entry.picture);
    }
    say_which(missing, entries.size(), "is not here", "are not here");
}

// Those of the sequence that none of the entries is of, by the same options: they may have been made by others.
void say_which_have_no_line(const FrameSequence& sequence, const ManifestEntry& example,
                            const std::vector<ManifestEntry>& entries) {
    std::set<std::int64_t> known;
    for (const ManifestEntry& entry : entries) {
        if (entry.scene == example.scene && options_of_one(entry) == options_of_one(example)) known.insert(entry.frame);
    }
    std::vector<std::string> missing;
    for (const Shot& shot : sequence.shots()) {
        if (!known.contains(shot.number)) missing.push_back(example.scene + ", " + std::to_string(shot.number));
    }
    say_which(missing, sequence.shots().size(), "has no line", "have no line");
}

// Pictures of one scene and one camera by the same options, some of `all` entries.
ExitCode verify_alike(const std::vector<ManifestEntry>& entries, const std::vector<ManifestEntry>& all, const VerifyOptions& verify,
                      Progress& progress) {
    const ManifestEntry& first = entries.front();
    RenderOptions options = verify.parse_render(first.scene, first.options);
    if (verify.backend) options.backend = *verify.backend;
    require_sum(first.scene, first.scene_sum);
    if (options.fit.camera) {
        if (!first.camera_sum) throw InputError(first.scene + ": found '--camera' in a manifest, expected 'camera_sha256' with it");
        require_sum(*options.fit.camera, *first.camera_sum);
    }
    std::shared_ptr<FrameSequence> sequence;
    if (options.frames.several()) {
        sequence = std::make_shared<FrameSequence>(first.scene, options, progress);
        say_which_have_no_line(*sequence, first, all);
        sequence->prepare(progress);
    }
    ExitCode worst = ExitCode::done;
    std::vector<RenderJob> jobs;
    for (const ManifestEntry& entry : entries) {
        if (sequence && entry.place >= sequence->shots().size()) {
            throw InputError(entry.scene + ": found picture " + std::to_string(entry.place) + " in a manifest, expected at most " +
                             std::to_string(sequence->shots().size() - 1));
        }
        if (sequence && entry.frame != sequence->shots()[entry.place].number) {
            throw InputError(entry.scene + ": found picture " + std::to_string(entry.place) + " with the number " +
                             std::to_string(entry.frame) + " in a manifest, expected " +
                             std::to_string(sequence->shots()[entry.place].number));
        }
        worst = std::max(worst, state_of_file(entry));
        RenderJob job;
        job.scene = entry.scene;
        job.label = entry.picture.value_or(entry.scene + ", " + std::to_string(entry.frame));
        job.scene_label = entry.scene;
        job.name = name_in_patterns(entry.scene);
        job.sequence = sequence;
        job.shot = entry.place;
        job.pixels_sum = entry.pixels_sum;
        jobs.push_back(job);
    }
    return std::max(worst, run_jobs(options, jobs, {}, progress));
}

}  // namespace

ExitCode run_verify(const VerifyOptions& options) {
    std::vector<ManifestEntry> all;
    for (const std::string& path : options.manifests) {
        const auto [some, cut_off] = read_manifest(path);
        std::set<std::string> others;
        for (const ManifestEntry& entry : some) {
            if (entry.version != version) others.insert(entry.version);
        }
        if (!others.empty()) {
            say(path + ": there are pictures by sphereview " +
                joined(std::vector<std::string>(others.begin(), others.end()), ", ") + "; this is " + std::string(version));
        }
        if (cut_off) say(place_in(path, {*cut_off, 1}) + "the line is cut off: its picture is not looked at");
        all.insert(all.end(), some.begin(), some.end());
    }
    // One manifest may be without a line: of a part of fewer frames than there are parts.
    if (all.empty()) throw InputError(options.manifests.front() + ": found no whole line, expected one for each picture");
    leave_out_twins(all);
    say_which_are_not_here(all);
    const std::vector<ManifestEntry> entries = sample_of(all, options.sample);
    // With the sums: manifests may be from before and after a change of a file.
    using MadeOf = std::tuple<std::string, std::string, std::optional<std::string>, std::vector<std::string>>;
    std::map<MadeOf, std::vector<ManifestEntry>> groups;
    for (const ManifestEntry& entry : entries) {
        groups[{entry.scene, entry.scene_sum, entry.camera_sum, entry.options}].push_back(entry);
    }
    Progress progress;
    ExitCode worst = ExitCode::done;
    for (const auto& [made_of, alike] : groups) worst = std::max(worst, verify_alike(alike, all, options, progress));
    write_output(std::string(standard_stream),
                 in_groups(entries.size()) + " of " + in_groups(all.size()) +
                     " pictures rendered again: " + (worst == ExitCode::done ? "all are equal" : "not all are equal") + "\n");
    return worst;
}

}  // namespace sphereview

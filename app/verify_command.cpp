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
#include <utility>
#include <vector>

#include "app/failure.hpp"
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

// Names pictures that are missing. A missing picture may be elsewhere, so it does not count as different.
void say_which_are_not_here(const std::vector<ManifestEntry>& entries) {
    std::vector<std::string> missing;
    for (const ManifestEntry& entry : entries) {
        if (entry.picture && !is_here(*entry.picture)) missing.push_back(*entry.picture);
    }
    say_which(missing, entries.size(), "is not here", "are not here");
}

std::string label_of(const ManifestEntry& entry) {
    return entry.picture.value_or(entry.scene + ", " + std::to_string(entry.frame));
}

// What is wrong with a line or a scene is said, once, and the others are looked at.
class Verification {
public:
    // `entries` must outlive this, as `verify` must.
    Verification(const std::vector<ManifestEntry>& entries, const VerifyOptions& verify) : entries_(entries), verify_(verify) {}

    ExitCode run() {
        std::vector<ManifestEntry> fit;
        std::vector<std::string> unfit;
        std::map<MadeOf, Alike> groups;
        for (const ManifestEntry& entry : entries_) {
            const auto [group, is_new] = groups.try_emplace(made_of(entry));
            if (is_new) group->second.options = checked_options(entry);
            if (group->second.options) {
                fit.push_back(entry);
            } else {
                unfit.push_back(label_of(entry));
            }
        }
        if (!fit.empty()) {
            for (const ManifestEntry& entry : sample_of(fit, verify_.sample)) {
                groups.at(made_of(entry)).sample.push_back(entry);
            }
        }
        for (const auto& [what, alike] : groups) {
            if (alike.sample.empty()) continue;
            try {
                render(*alike.options, alike.sample);
            } catch (...) {
                say_failure(alike.sample.front().scene);
            }
        }
        say_which(unfit, entries_.size(), "cannot be rendered again", "cannot be rendered again");
        say_which_have_no_line(fit);
        write_output(std::string(standard_stream),
                     in_groups(rendered_) + " of " + in_groups(entries_.size()) +
                         " pictures rendered again: " + (worst_ == ExitCode::done ? "all are equal" : "not all are equal") + "\n");
        return worst_;
    }

private:
    // Pictures of one scene and one camera by the same options.
    struct Alike {
        std::optional<RenderOptions> options{};  // none: they cannot be rendered again
        std::vector<ManifestEntry> sample{};
    };
    // With the sums: manifests may be from before and after a change of a file.
    using MadeOf = std::tuple<std::string, std::string, std::optional<std::string>, std::vector<std::string>>;
    static MadeOf made_of(const ManifestEntry& entry) { return {entry.scene, entry.scene_sum, entry.camera_sum, entry.options}; }

    void say_bad_input(const std::string& line) {
        worst_ = std::max(worst_, ExitCode::bad_input);
        if (said_.insert(line).second) say(line);
    }

    // Reports the exception being handled.
    void say_failure(const std::string& scene) {
        const Failure failure = describe_current_exception(scene);
        progress_.clear();
        worst_ = std::max(worst_, failure.code);
        if (said_.insert(failure.message).second) say(failure.message);
    }

    // Nothing where the line is wrong, or the scene or the camera is not the file that the picture was made of.
    std::optional<RenderOptions> checked_options(const ManifestEntry& entry) {
        try {
            RenderOptions options = verify_.parse_render(entry.scene, entry.options, entry.where);
            if (verify_.backend) options.backend = *verify_.backend;
            require_sum(entry.scene, entry.scene_sum);
            if (options.fit.camera && !entry.camera_sum) {
                throw InputError(entry.where + "found '--camera', expected 'camera_sha256' with it");
            }
            if (options.fit.camera) require_sum(*options.fit.camera, *entry.camera_sum);
            return options;
        } catch (const InputError&) {
            say_failure(entry.scene);
            return std::nullopt;
        }
    }

    // Throws InputError where the file is not the one that the pictures were made of.
    void require_sum(const std::string& file, const std::string& sum) {
        auto found = sums_.find(file);
        if (found == sums_.end()) found = sums_.emplace(file, sum_of_file(file)).first;
        if (found->second == sum) return;
        throw InputError(file + ": found another file than the pictures were made of: its SHA-256 is " + found->second +
                         ", expected " + sum);
    }

    // What is wrong with the place, in words; "" where nothing is.
    static std::string fault_of_place(const ManifestEntry& entry, const std::vector<Shot>& shots) {
        const std::string found = entry.where + entry.scene + ": found picture " + std::to_string(entry.place);
        if (entry.place >= shots.size()) return found + " in a manifest, expected at most " + std::to_string(shots.size() - 1);
        const std::int64_t expected = shots[entry.place].number;
        if (entry.frame == expected) return "";
        return found + " with the number " + std::to_string(entry.frame) + " in a manifest, expected " + std::to_string(expected);
    }

    void render(const RenderOptions& options, const std::vector<ManifestEntry>& sample) {
        const ManifestEntry& first = sample.front();
        std::shared_ptr<FrameSequence> sequence;
        if (options.frames.several()) {
            sequence = std::make_shared<FrameSequence>(first.scene, options, progress_);
            for (const Shot& shot : sequence->shots()) expected_[{first.scene, options_of_one(first)}].insert(shot.number);
            sequence->prepare(progress_);
        }
        std::vector<RenderJob> jobs;
        for (const ManifestEntry& entry : sample) {
            if (const std::string fault = sequence ? fault_of_place(entry, sequence->shots()) : ""; !fault.empty()) {
                say_bad_input(fault);
                continue;
            }
            worst_ = std::max(worst_, state_of_file(entry));
            RenderJob job;
            job.scene = entry.scene;
            job.label = label_of(entry);
            job.scene_label = entry.scene;
            job.name = name_in_patterns(entry.scene);
            job.sequence = sequence;
            job.shot = entry.place;
            job.pixels_sum = entry.pixels_sum;
            jobs.push_back(job);
        }
        if (jobs.empty()) return;
        rendered_ += jobs.size();
        worst_ = std::max(worst_, run_jobs(options, jobs, {}, progress_));
    }

    // Names frames of the sequences that no entry has. Another part's manifest may have them.
    void say_which_have_no_line(const std::vector<ManifestEntry>& entries) const {
        auto missing = expected_;
        for (const ManifestEntry& entry : entries) {
            const auto of_these = missing.find({entry.scene, options_of_one(entry)});
            if (of_these != missing.end()) of_these->second.erase(entry.frame);
        }
        for (const auto& [made_of, numbers] : missing) {
            std::vector<std::string> labels;
            for (const std::int64_t number : numbers) labels.push_back(made_of.first + ", " + std::to_string(number));
            say_which(labels, expected_.at(made_of).size(), "has no line", "have no line");
        }
    }

    const std::vector<ManifestEntry>& entries_;
    const VerifyOptions& verify_;
    Progress progress_{};
    ExitCode worst_ = ExitCode::done;
    std::size_t rendered_ = 0;
    std::set<std::string> said_{};
    std::map<std::string, std::string> sums_{};  // of the files that were looked at
    // The numbers of the pictures of a scene by the options of one, whatever the lists of frames.
    std::map<std::pair<std::string, std::vector<std::string>>, std::set<std::int64_t>> expected_{};
};

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
    return Verification(all, options).run();
}

}  // namespace sphereview

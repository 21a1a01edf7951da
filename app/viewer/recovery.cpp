#include "viewer/recovery.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string_view>
#include <system_error>

#include "base/file_lock.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/path.hpp"
#include "base/text.hpp"
#include "base/user_folders.hpp"
#include "formats/scene_format.hpp"
#include "viewer/settings.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

// The file begins with two comments, or three, so that they are replaced in one step with the scene.
constexpr std::string_view prefix = "recovery-";
constexpr std::string_view ending = ".toml";
constexpr std::string_view lock_ending = ".lock";
constexpr std::string_view time_mark = "# sphereview recovery, milliseconds since 1970: ";
constexpr std::string_view original_mark = "# of: ";
constexpr std::string_view frame_mark = "# frame, bytes and time of the file, whether numbers are the file's: ";

using Milliseconds = std::chrono::milliseconds;
constexpr auto latest =
    std::chrono::duration_cast<Milliseconds>(std::chrono::system_clock::duration::max());  // that the clock can say

// A file beside the recovery tells by its lock that the process runs which wrote both: the recovery itself is always replaced.
fs::path lock_of(fs::path file) { return file.replace_extension(lock_ending); }

// What this process keeps.
class Own {
public:
    // The file in `folder` for a copy that has the changes of so many spheres. Where no lock can be made, others take it for left
    // behind, which is better than to keep nothing; each further write tries again.
    fs::path in(const fs::path& folder, std::size_t complete_up_to) {
        const std::lock_guard guard(mutex_);
        if (now_.complete_up_to > complete_up_to) {
            earlier_.push_back(std::move(now_));
            now_ = Copy();
        }
        if (now_.file.empty() || now_.file.parent_path() != folder) {
            const auto now = std::chrono::system_clock::now().time_since_epoch().count();
            now_ = Copy();
            now_.file = folder / (std::string(prefix) + std::to_string(now) + std::string(ending));
        }
        if (!now_.lock.holds()) now_.lock = FileLock(lock_of(now_.file));
        return now_.file;
    }
    // The current copy is written. Earlier copies that are complete up to the same sphere, or fewer, are superseded.
    void note_written(std::size_t complete_up_to) {
        const std::lock_guard guard(mutex_);
        now_.complete_up_to = complete_up_to;
        std::erase_if(earlier_, [&](const Copy& copy) {
            return copy.complete_up_to <= complete_up_to && remove_recovery(text_from(copy.file));
        });
    }
    bool remove() {
        const std::lock_guard guard(mutex_);
        std::erase_if(earlier_, [](const Copy& copy) { return remove_recovery(text_from(copy.file)); });
        const bool done = now_.file.empty() || remove_recovery(text_from(now_.file));
        now_ = Copy();
        return done && earlier_.empty();
    }

private:
    struct Copy {
        fs::path file{};
        FileLock lock{};
        std::size_t complete_up_to = 0;  // nothing is written yet
    };

    std::mutex mutex_{};  // edits are kept on a thread of their own
    Copy now_{};
    std::vector<Copy> earlier_{};  // of frames that have spheres which those after them lack
};

Own& own() {
    static Own own;
    return own;
}

// A path may hold any byte, a comment may not: all but plain characters become %XX.
std::string escaped(std::string_view path) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string text;
    for (const char character : path) {
        const auto byte = static_cast<unsigned char>(character);
        if (byte > ' ' && byte < 0x7F && byte != '%') {
            text += character;
        } else {
            text += '%';
            text += digits[byte >> 4];
            text += digits[byte & 15];
        }
    }
    return text;
}

std::optional<std::string> unescaped(std::string_view text) {
    std::string path;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            path += text[i];
            continue;
        }
        unsigned byte = 0;
        if (i + 2 >= text.size()) return {};
        const char* begin = text.data() + i + 1;
        if (const auto read = std::from_chars(begin, begin + 2, byte, 16); read.ptr != begin + 2) return {};
        path += static_cast<char>(byte);
        i += 2;
    }
    return path;
}

// What follows `mark` on the first line of `text`, which loses that line; nothing if the line begins otherwise.
std::optional<std::string_view> marked_line(std::string_view& text, std::string_view mark) {
    const std::string_view line = take_line(text);
    return line.starts_with(mark) ? std::optional(line.substr(mark.size())) : std::nullopt;
}

std::string in_numbers(const EditedFrame& frame) {
    return std::to_string(frame.number) + ' ' + std::to_string(frame.file_size) + ' ' + std::to_string(frame.file_time) + ' ' +
           (frame.has_numbers ? '1' : '0');
}

std::optional<EditedFrame> frame_from(std::string_view numbers) {
    std::array<std::int64_t, 4> values{};
    for (std::int64_t& value : values) {
        if (!numbers.empty() && numbers.front() == ' ') numbers.remove_prefix(1);
        const auto read = std::from_chars(numbers.data(), numbers.data() + numbers.size(), value);
        if (read.ec != std::errc()) return {};
        numbers.remove_prefix(static_cast<std::size_t>(read.ptr - numbers.data()));
    }
    if (values[0] < 0) return {};
    return EditedFrame{values[0], values[1], values[2], values[3] != 0};
}

std::optional<Recovery> read_head(const fs::path& file) {
    constexpr std::size_t longest_head = 65536;
    InputStream stream(text_from(file));
    stream.fill(longest_head);
    std::string_view text = stream.bytes();
    const auto time = marked_line(text, time_mark);
    const auto original = marked_line(text, original_mark);
    std::int64_t count = 0;
    if (!time || !original || std::from_chars(time->data(), time->data() + time->size(), count).ec != std::errc()) return {};
    const auto path = unescaped(*original);
    if (!path || count < 0 || Milliseconds(count) > latest) return {};
    const auto frame = marked_line(text, frame_mark);
    return Recovery{text_from(file),
                    {*path, frame ? frame_from(*frame) : std::nullopt},
                    std::chrono::system_clock::time_point(Milliseconds(count))};
}

// The recovery files whose processes hold their locks, or have ended, or may have.
std::vector<fs::path> files_of(FileLock::Holder holder) {
    std::vector<fs::path> files;
    std::error_code error;
    const fs::path folder = state_folder();
    if (folder.empty()) return files;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code ignored;
        const fs::path& file = entry->path();
        const std::string name = text_from(file.filename());
        if (!entry->is_regular_file(ignored) || !name.starts_with(prefix) || !name.ends_with(ending)) continue;
        if (FileLock::holder_of(lock_of(file)) == holder) files.push_back(file);
    }
    return files;
}

}  // namespace

std::optional<EditedFrame> edited_frame(const FileStates& file, std::int64_t number, bool has_numbers) {
    const auto state = file.find("");
    if (state == file.end()) return std::nullopt;
    return EditedFrame{number, static_cast<std::int64_t>(state->second.size),
                       static_cast<std::int64_t>(state->second.time.time_since_epoch().count()), has_numbers};
}

EditedFile edited_file(const ViewerState& state) {
    // Where a reload was undone, the document is of a file that is no more.
    if (!has_several_frames(state) || state.player.edits.outdated) return {state.path, {}};
    return {state.path, edited_frame(state.read_stamp, state.frame, has_numbers_of_file(state))};
}

bool write_recovery(const Scene& scene, const EditedFile& original, std::size_t complete_up_to) noexcept {
    try {
        const fs::path folder = state_folder();
        if (!make_user_folder(folder)) return false;
        const auto now = std::chrono::system_clock::now().time_since_epoch();
        std::string text(time_mark);
        text += std::to_string(std::chrono::duration_cast<Milliseconds>(now).count());
        text += '\n';
        text += original_mark;
        text += escaped(original.path.empty() ? "" : absolute_path(original.path));
        text += '\n';
        if (original.frame) text += std::string(frame_mark) + in_numbers(*original.frame) + '\n';
        text += write_scene(scene, SceneFormat::toml);
        write_output(text_from(own().in(folder, complete_up_to)), text);
        own().note_written(complete_up_to);
        return true;
    } catch (...) {
        return false;
    }
}

std::vector<Recovery> list_recoveries() {
    std::vector<Recovery> recoveries;
    for (const fs::path& file : files_of(FileLock::Holder::nobody)) {
        try {
            if (auto recovery = read_head(file)) recoveries.push_back(std::move(*recovery));
        } catch (const std::exception&) {
            // Unreadable, or just taken by another viewer.
        }
    }
    std::ranges::sort(recoveries, std::ranges::greater(), &Recovery::time);
    return recoveries;
}

std::string in_words(const Recovery& recovery) {
    const std::string& of = recovery.original.path;
    return "sphereview ended with unsaved changes of " + (of.empty() ? std::string("an untitled scene") : on_one_line(of)) + ".";
}

std::vector<std::string> unclear_recoveries() {
    std::vector<std::string> names;
    for (const fs::path& file : files_of(FileLock::Holder::unknown)) names.push_back(text_from(file));
    std::ranges::sort(names);
    return names;
}

bool remove_recovery(const std::string& file) noexcept {
    std::error_code error;
    try {
        fs::remove(path_from(file), error);
        std::error_code ignored;
        fs::remove(lock_of(path_from(file)), ignored);
        return !error;
    } catch (const std::exception&) {
        return false;
    }
}

bool remove_own_recovery() noexcept {
    try {
        return own().remove();
    } catch (const std::exception&) {
        return false;
    }
}

void Autosave::look(const Document& document, const EditedFile& original, Clock::time_point now) {
    if (job_ && !job_->ended()) {
        due_ = now + look_again;
        return;
    }
    finish();
    if (!document.is_changed()) {
        if (kept_) remove_own_recovery();
        kept_ = false;
        tried_ = 0;
        complete_up_to_ = all_spheres;
        due_.reset();
    } else if (document.revision() == tried_) {
        due_.reset();
    } else if (!due_) {
        due_ = now + pause_;
    } else if (now >= *due_) {
        begin(document, original);
        due_ = now + look_again;
    }
}

void Autosave::begin(const Document& document, const EditedFile& original) {
    tried_ = document.revision();
    kept_ = true;
    due_.reset();
    try {
        // The copy that is being written comes first, or it would replace this newer one.
        auto job =
            std::make_shared<BackgroundJob>([scene = std::make_shared<const Scene>(document.scene()), original,
                                             complete_up_to = complete_up_to_, earlier = job_, written = written_](WorkControl&) {
                if (earlier) earlier->wait();
                const auto begin = Clock::now();
                written->done = write_recovery(*scene, original, complete_up_to);
                written->took = Clock::now() - begin;
            });
        if (job->ended()) job->rethrow();
        job_ = std::move(job);
    } catch (const std::exception&) {  // there is no memory for a copy, or no thread
        finish();
        written_->done = write_recovery(document.scene(), original, complete_up_to_);
    }
}

void Autosave::finish() {
    if (!job_) return;
    job_->wait();
    pause_ = std::max(shortest_pause, pauses_per_write * written_->took.load());
    due_.reset();
    job_.reset();
}

bool Autosave::keep(const Document& document, const EditedFile& original) {
    begin(document, original);
    finish();
    return written_->done;
}

std::shared_ptr<const BackgroundJob> Autosave::keep_before_reading(const Document& document, const EditedFile& original) {
    if (document.is_changed() && document.revision() != tried_) begin(document, original);
    return job_;
}

void Autosave::shows_frame(const Document& document, bool lacks_changed_spheres) {
    complete_up_to_ = lacks_changed_spheres ? document.scene().spheres.size() : all_spheres;
    if (lacks_changed_spheres && kept_) tried_ = instead_of_ = document.revision();
}

bool Autosave::keep_at_end(const Document& document, const EditedFile& original) const {
    const bool stays = kept_ && instead_of_ == document.revision() && written_->done;
    return stays || write_recovery(document.scene(), original, complete_up_to_);
}

std::string keep_unsaved(const ViewerState& state) {
    if (!state.document.is_changed() && !state.saving) return "";  // a save may not be finished
    const bool kept = state.autosave.keep_at_end(state.document, edited_file(state));
    return "unsaved changes of " + state.name() + (kept ? " are kept; the next start offers them" : " could not be kept");
}

std::optional<std::string> keep_unsaved_of_hung_loop(ViewerState& state, std::chrono::milliseconds limit) {
    if (!state.changing.try_lock_for(limit)) return std::nullopt;
    state.autosave.finish();  // an older copy must not replace this one
    return keep_unsaved(state);
}

}  // namespace sphereview

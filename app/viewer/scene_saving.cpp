#include "viewer/scene_saving.hpp"

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/gunzip.hpp"
#include "base/input_file.hpp"
#include "base/nesting.hpp"
#include "base/path.hpp"
#include "base/text.hpp"
#include "formats/scene_format.hpp"
#include "viewer/frame_player.hpp"
#include "viewer/scene_file.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

void after(Work& work, const std::function<void()>& next) {
    work.done = [done = std::move(work.done), next] {
        done();
        next();
    };
}

void write(ViewerState& state, const std::string& path, SceneFormat format, const std::function<void()>& then) {
    if (state.saving) return after(*state.saving, [&state, path, format, then] { write(state, path, format, then); });
    const auto done = [&state, path, format, then] {
        state.path = path;
        state.format = format;
        state.frame = 0;
        end_frames(state);
        state.stamp = state.read_stamp = file_states(path);
        state.property_names.clear();
        for (const Property& property : state.scene().properties) state.property_names.push_back(property.name);
        forget_file_messages(state);
        add_recent(state.settings, path);
        announce(state, "Saved " + on_one_line(path));
        then();
    };
    const auto fail = [&state](const std::string& why) {
        state.document.mark_unsaved();
        report_error(state, "The scene cannot be saved", why);
    };
    // Already now: what is edited while a copy is written is not in it. Until the file is whole nobody relies on it.
    state.document.mark_saved();
    start_saving(state, path, format, done, fail);
}

void ask_where_to_save(ViewerState& state, SceneFormat format, const std::function<void()>& then);

std::string words_of_unsaved(const ViewerState& state) {
    const std::string words = in_quotes(state.name()) + " has changes that are not saved.";
    if (!lacks_edited_spheres(state)) return words;
    return words + "\nSome are of spheres that frame " + std::to_string(state.frame) +
           " does not have: only a frame that has them can be saved with them.";
}

void write_unless_lost(ViewerState& state, const std::string& path, SceneFormat format, const std::function<void()>& then) {
    const std::string lost = lost_in(state.scene(), format);
    if (lost.empty()) return write(state, path, format, then);
    state.dialogs.push_back(Question{.id = "text-loses",
                                     .title = "The text format cannot hold everything",
                                     .text = in_quotes(text_from(path_from(path).filename())) + " would lose: " + lost + ".",
                                     .answers = {"Save as TOML...", "Save all the same", "Cancel"},
                                     .cancel = 2,
                                     .answer = [&state, path, format, then](int answer) {
                                         if (answer == 0) ask_where_to_save(state, SceneFormat::toml, then);
                                         if (answer == 1) write(state, path, format, then);
                                     }});
}

// Whether the file has comments of a person's, which the native format's tree does not hold. Looked for in the file and not kept
// from its reading: it may have been changed, or its edits recovered. Large files are no person's.
bool has_comments(const std::string& path) {
    if (std::error_code error; !is_read_at_once(path) || !fs::is_regular_file(path_from(path), error)) return false;
    try {
        const InputFile file(path);
        return file.bytes() != SceneFormat::toml.write(Scene{}) && has_comment(file.bytes());
    } catch (const std::runtime_error&) {
        return false;
    }
}

void ask_where_to_save(ViewerState& state, SceneFormat format, const std::function<void()>& then) {
    const std::string ending(is_written(format) ? format.endings[0] : SceneFormat::toml.endings[0]);
    const fs::path stem = state.path.empty() ? "scene" : path_from(without_gzip_ending(state.path)).stem();
    const fs::path folder = path_from(file_dialog(state).folder);
    FileBrowser browser = saving_dialog(state, "Save the scene", text_from(folder / path_from(text_from(stem) + ending)));
    browser.kinds = kinds_of(is_written);
    const auto chosen =
        std::ranges::find(browser.kinds, is_written(format) ? format.name : SceneFormat::toml.name, &FileKind::name);
    browser.kind = static_cast<decltype(browser.kind)>(chosen - browser.kinds.begin());
    browser.accept = [&state, then](const std::string& path, PictureSize) {
        const std::string absolute = absolute_path(path);
        if (const std::string fault = name_fault(absolute); !fault.empty()) {
            return report_error(state, "The scene cannot be saved",
                                in_quotes(text_from(path_from(absolute).filename())) + " is " + fault + ".");
        }
        const auto go_on = [&state, absolute, then] { write_unless_lost(state, absolute, format_of_name(absolute), then); };
        if (!lacks_edited_spheres(state)) return go_on();
        state.dialogs.push_back(Question{.id = "frame-loses",
                                         .title = "The frame does not have all that is changed",
                                         .text = words_of_unsaved(state),
                                         .answers = {"Save all the same", "Cancel"},
                                         .cancel = 1,
                                         .answer = [go_on](int answer) {
                                             if (answer == 0) go_on();
                                         }});
    };
    state.dialogs.push_back(std::move(browser));
}

// Quitting must not lose a film that may have taken hours.
void ask_about_film(ViewerState& state) {
    ask(state, {.id = "film-is-made",
                .title = "Quit without the film?",
                .text = in_quotes(text_from(path_from(state.filming->path).filename())) + " is not made yet.",
                .answers = {"Quit when it is done", "Quit without it", "Cancel"},
                .cancel = 2,
                .answer = [&state](int answer) {
                    if (answer == 1 || !state.filming) with_edits_safe(state, [&state] { state.quits = true; });
                    if (answer != 0 || !state.filming) return;
                    state.filming->then_quit = true;
                    announce(state, "Closes when the film is made; close again to close without it");
                    after(*state.filming, [&state] { quit(state); });
                }});
}

}  // namespace

void ask(ViewerState& state, Question question) {
    for (Dialog& dialog : state.dialogs) {
        auto* waiting = std::get_if<Question>(&dialog);
        if (waiting == nullptr || waiting->id != question.id) continue;
        *waiting = std::move(question);
        return;
    }
    state.dialogs.push_back(std::move(question));
}

void with_edits_safe(ViewerState& state, std::function<void()> then, const std::string& question) {
    if (state.saving) {
        return after(*state.saving, [&state, then = std::move(then), question] { with_edits_safe(state, then, question); });
    }
    if (!state.document.is_changed()) return then();
    ask(state, {.id = "save-changes",
                .title = "Save changes?",
                .text = question.empty() ? words_of_unsaved(state) : question,
                .answers = {"Save", "Don't save", "Cancel"},
                .cancel = 2,
                .answer = [&state, then = std::move(then)](int answer) {
                    if (answer == 0) save_scene(state, then);
                    if (answer == 1) then();
                }});
}

std::function<void(LoadedScene)> unless_edited(ViewerState& state, std::function<void(LoadedScene)> then) {
    return [&state, revision = state.document.revision(), then = std::move(then)](LoadedScene loaded) {
        if (state.document.revision() == revision) return then(std::move(loaded));
        with_edits_safe(state, [then, kept = std::make_shared<LoadedScene>(std::move(loaded))] { then(std::move(*kept)); });
    };
}

void save_scene(ViewerState& state, const std::function<void()>& then) {
    if (state.path.empty() || !is_written(state.format) || !name_fault(state.path).empty()) return save_scene_as(state, then);
    if (state.format != SceneFormat::toml || !has_comments(state.path))
        return write_unless_lost(state, state.path, state.format, then);
    state.dialogs.push_back(Question{.id = "drops-comments",
                                     .title = "Saving leaves the comments out",
                                     .text = in_quotes(state.name()) + " has comments. A save writes the file anew, without them.",
                                     .answers = {"Save as...", "Save without comments", "Cancel"},
                                     .cancel = 2,
                                     .answer = [&state, then](int answer) {
                                         if (answer == 0) save_scene_as(state, then);
                                         if (answer == 1) write(state, state.path, state.format, then);
                                     }});
}

void save_scene_as(ViewerState& state, const std::function<void()>& then) { ask_where_to_save(state, state.format, then); }

void quit(ViewerState& state) {
    if (state.exporting && !state.exporting->then_quit) {
        state.exporting->then_quit = true;
        announce(state,
                 "Closes when " + on_one_line(state.exporting->shown_path()) + " is written; close again to close without it");
        return after(*state.exporting, [&state] { quit(state); });
    }
    if (state.filming && !state.filming->then_quit) return ask_about_film(state);
    with_edits_safe(state, [&state] { state.quits = true; });
}

}  // namespace sphereview

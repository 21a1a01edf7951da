#include "viewer/film_export.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/failure.hpp"
#include "app/film.hpp"
#include "app/frame_sequence.hpp"
#include "app/render_plan.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "base/path.hpp"
#include "base/text.hpp"
#include "base/user_folders.hpp"
#include "viewer/film_job.hpp"
#include "viewer/picture_job.hpp"
#include "viewer/scene_file.hpp"
#include "viewer/view_marks.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

constexpr std::int64_t most_of_turn = 1'000'000;  // as --turntable has it
// Frames of a range that a dialog takes for granted while the file is still looked through: as many numbers are kept.
constexpr std::int64_t most_expected = 1'000'000;
constexpr const char* no_encoder =
    "A film needs the program ffmpeg, and the folders of PATH have none. Install it (Debian, Ubuntu: apt install ffmpeg; Fedora: "
    "dnf "
    "install ffmpeg-free; macOS: brew install ffmpeg; Windows: winget install ffmpeg), or choose Pictures.";

// What the pictures are called that a film is not made of.
constexpr const char* usual_pictures = "{name}-{frame:05}.png";

bool is_pictures(const std::string& path) {
    const FilmKind* kind = film_kind(path);
    return kind && kind->ending == ".png" && has_frame(path);
}

std::string name_of_scene(const ViewerState& state) { return state.path.empty() ? "untitled" : state.path; }

// The kinds of a film's file; pictures before the animated PNG, which has the same ending.
std::vector<FileKind> kinds_of_film(const std::string& name) {
    std::vector<FileKind> kinds;
    for (const FilmKind& kind : film_kinds()) {
        if (kind.ending == ".png") kinds.push_back({"Pictures", {".png"}, "{frame", usual_pictures});
        const std::string ending(kind.ending);
        kinds.push_back({std::string(kind.title), {ending}, {}, name + ending});
    }
    return kinds;
}

// "33.3 s", "2 min 13 s", "1 h 5 min".
std::string duration(double seconds) {
    if (seconds < 60.0) return fixed(seconds, 1) + " s";
    const auto whole = static_cast<std::int64_t>(seconds + 0.5);
    if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
}

// "about 4 min left".
std::string time_left(double seconds) {
    const auto counted = [](double number, const char* unit) { return "about " + fixed(number, 0) + unit + " left"; };
    if (seconds < 90.0) return counted(std::max(seconds, 1.0), " s");
    if (seconds < 5400.0) return counted(seconds / 60.0, " min");
    return counted(seconds / 3600.0, " h");
}

std::string pictures_in_words(std::size_t count) { return in_groups(count) + (count == 1 ? " picture" : " pictures"); }

// The pictures that are chosen, of a file of so many frames. Throws InputError.
std::vector<Shot> chosen_shots(const FilmForm& form, const std::string& scene) {
    if (!form.takes_frames() && !form.turns()) {
        throw InputError("Nothing is chosen: expected the frames, a turntable, or both.");
    }
    if (form.turns() && (form.chosen.turntable < 1 || form.chosen.turntable > most_of_turn)) {
        throw InputError("The turntable has " + std::to_string(form.chosen.turntable) + " pictures, expected 1 to " +
                         in_groups(most_of_turn) + ".");
    }
    std::vector<std::int64_t> frames = {0};
    if (form.takes_frames()) {
        auto ranges = parse_frames(form.chosen.frames);
        if (!ranges) throw InputError("The frames are " + in_quotes(form.chosen.frames) + ", expected " + frames_syntax + ".");
        for (FrameRange& range : *ranges) {
            if (!form.counting || !range.last) continue;
            const std::int64_t first = std::clamp(range.first.value_or(0), std::int64_t{0}, FrameReader::most_frames);
            range.last = std::min(*range.last, std::max(form.frames, first + most_expected));
        }
        frames = frames_in(*ranges, text_from(path_from(scene).filename()), [&](std::int64_t enough) {
            const bool may_have = form.counting && enough < FrameReader::most_frames;
            return may_have ? enough : std::min(enough, form.frames);
        });
    }
    return shots_of(frames, form.turns() ? form.chosen.turntable : 0);
}

FrameRate chosen_rate(const FilmForm& form, const FilmKind* kind) {
    const auto rate = parse_frame_rate(form.chosen.rate);
    const std::string instead = !rate  ? "a whole number or a fraction such as 30000/1001"
                                : kind ? rates_instead_of(*rate, *kind)
                                       : "";
    if (!instead.empty()) {
        throw InputError("The pictures a second are " + in_quotes(form.chosen.rate) + ", expected " + instead + ".");
    }
    return *rate;
}

FilmJudgement judgement(const FilmForm& form, const std::string& path, const std::string& scene, bool has_encoder) {
    FilmJudgement judged;
    const FilmKind* kind = film_kind(path);
    judged.is_film = !is_pictures(path);
    judged.has_quality = judged.is_film && kind && kind->has_quality();
    judged.has_alpha = !judged.is_film || (kind && kind->has_alpha());
    try {
        const std::vector<Shot> shots = chosen_shots(form, scene);
        judged.summary = (form.counting && form.takes_frames() ? "At least " : "") + pictures_in_words(shots.size());
        if (!judged.is_film) {
            const auto picture = [&](const Shot& shot) {
                const std::string filled = fill_in(path, {.name = name_in_patterns(scene), .frame = shot.number});
                return text_from(path_from(filled).filename());
            };
            judged.summary += ": " + picture(shots.front());
            if (shots.size() > 1) judged.summary += " to " + picture(shots.back());
            return judged;
        }
        const FrameRate rate = chosen_rate(form, kind);
        judged.summary += ", a film of " + duration(static_cast<double>(shots.size()) * rate.seconds / rate.pictures);
        if (!has_encoder) judged.fault = no_encoder;
    } catch (const InputError& error) {
        judged.fault = error.what();
    }
    return judged;
}

// The dialog stands while the file is looked through.
bool note_frames(const ViewerState& state, FilmForm& form) {
    const std::int64_t frames = has_several_frames(state) ? std::max<std::int64_t>(state.frames, 2) : 1;
    const bool counting = !state.player.all_frames;
    const bool are_others = frames != form.frames || counting != form.counting;
    form.frames = frames;
    form.counting = counting;
    return are_others;
}

FilmForm new_form(const ViewerState& state) {
    FilmForm form;
    const std::string scene = name_of_scene(state);
    const bool has_encoder = !find_film_encoder().empty();
    form.refresh = [&state](FilmForm& shown) { return note_frames(state, shown); };
    form.refresh(form);
    form.chosen.samples = state.settings.samples;
    form.chosen.marks = state.settings.marks_exported;
    form.chosen.transparent = state.shown_background().transparent;
    form.chosen = state.film_choices.value_or(form.chosen);
    form.marks = shown_marks(state);
    form.from_file = "The file's frames. Colours, radii and hiding changed here hold in all, moves do not.";
    if (!has_numbers_of_file(state)) {
        form.from_file = "The file's frames. Spheres were added, deleted or reordered here: what was changed since is not in them.";
    }
    form.from_window = "The scene as the window shows it, with what is not saved.";
    form.judge = [scene, has_encoder](const FilmForm& judged, const std::string& path) {
        return judgement(judged, path, scene, has_encoder);
    };
    return form;
}

// One of the pictures that are there already, of the first thousands; "" for none.
std::string replaced_picture(const FilmRequest& request, const std::vector<Shot>& shots) {
    constexpr std::size_t most_looked_for = 5000;
    const std::string name = name_in_patterns(request.options.scenes.front());
    std::error_code error;
    for (std::size_t i = 0; i < std::min(shots.size(), most_looked_for); ++i) {
        std::string path = fill_in(*request.options.output, {.name = name, .frame = shots[i].number});
        if (fs::exists(fs::symlink_status(path_from(path), error))) return path;
    }
    return "";
}

void ask_for_film(ViewerState& state, const std::string& path, const std::string& fault);

// Asks before it replaces pictures.
void start_unless_replacing(ViewerState& state, const FilmRequest& request, const std::vector<Shot>& shots,
                            const std::string& path) {
    const std::string there = request.options.output ? replaced_picture(request, shots) : "";
    if (there.empty()) return start_film(state, request);
    const auto answer = [&state, request, path](bool replaces) {
        if (!replaces) return ask_for_film(state, path, "");
        start_film(state, request);
    };
    state.dialogs.push_back(
        replace_question("Replace pictures?", on_one_line(there) + "\n\nexists already, and perhaps others do.", answer));
}

void ask_for_film(ViewerState& state, const std::string& path, const std::string& fault) {
    FileBrowser browser = saving_dialog(state, "Export film", path, fault);
    browser.kinds = kinds_of_film(name_in_patterns(name_of_scene(state)));
    browser.only_kinds = true;
    browser.size = PictureSize{state.settings.film_width, state.settings.film_height};
    browser.view = state.picture_size;
    browser.film = std::make_shared<FilmForm>(new_form(state));
    browser.accept = [&state, form = browser.film](const std::string& chosen, PictureSize size) {
        choose_size(state, &ViewerSettings::film_width, &ViewerSettings::film_height, size);
        state.film_choices = form->chosen;
        form->refresh(*form);
        const auto ask_again = [&](const std::string& why) { ask_for_film(state, chosen, why); };
        if (state.filming) return ask_again(on_one_line(state.filming->path) + " is not exported yet");
        try {
            const FilmRequest request = film_request(state, *form, chosen, size);
            start_unless_replacing(state, request, chosen_shots(*form, name_of_scene(state)), chosen);
        } catch (const InputError& error) {
            ask_again(error.what());
        }
    };
    state.dialogs.push_back(std::move(browser));
}

// "12 of 100 pictures were done, and nothing is left of the film", or what there is of pictures; "" before there is any.
std::string how_far(const FilmRequest& request, const FilmStatus& status) {
    if (status.pictures() == 0) return "";
    const std::string counted = in_groups(status.done()) + " of " + pictures_in_words(status.pictures());
    return request.options.film.movie ? counted + " were done, and nothing is left of the film" : counted + " are written";
}

WorkShown words_of(const std::string& path, const FilmStatus& status) {
    const std::string what = "Exporting " + shown_text(text_from(path_from(path).filename())) + ": ";
    if (status.pictures() == 0) return {what + "reading the file", status.part(), true};
    const std::size_t now = std::min(status.done() + 1, status.pictures());
    std::string text = what + "picture " + in_groups(now) + " of " + in_groups(status.pictures());
    if (const auto left = status.seconds_left()) text += ", " + time_left(*left);
    return {text, status.part(), true};
}

std::string words_when_done(const FilmRequest& request, const std::string& path, const FilmStatus& status) {
    constexpr std::size_t most_warnings = 3;
    const auto& [width, height] = request.options.size;
    std::vector<std::string> lines = status.warnings();
    if (lines.size() > most_warnings) {
        const std::size_t more = lines.size() - most_warnings;
        lines.resize(most_warnings);
        lines.push_back("and " + in_groups(more) + " more warnings");
    }
    lines.insert(lines.begin(), "Exported " + on_one_line(path) + " (" + pictures_in_words(status.pictures()) + ", " +
                                    std::to_string(width) + " x " + std::to_string(height) + ")");
    return joined(lines, "\n");
}

}  // namespace

void ask_for_film(ViewerState& state) {
    const std::string scene = name_of_scene(state);
    const fs::path folder = state.path.empty() ? pictures_folder() : path_from(scene).parent_path();
    const std::string name = find_film_encoder().empty() ? usual_pictures : name_in_patterns(scene) + ".mp4";
    ask_for_film(state, text_from(folder / path_from(name)), "");
}

FilmRequest film_request(ViewerState& state, const FilmForm& form, const std::string& path, PictureSize size) {
    FilmRequest request;
    RenderOptions& options = request.options;
    const FilmChoices& chosen = form.chosen;
    const std::string scene = name_of_scene(state);
    chosen_shots(form, scene);
    const FilmJudgement judged = judgement(form, path, scene, true);
    if (std::max(size.width, size.height) > longest_side(chosen.samples)) {
        throw InputError("A picture with " + std::to_string(chosen.samples) + " samples a pixel can be at most " +
                         in_groups(static_cast<std::uint64_t>(longest_side(chosen.samples))) + " pixels wide and high.");
    }
    options.scenes = {scene};
    options.backend = Backend::cpu;
    options.size = size;
    options.samples = chosen.samples;
    options.shading = state.settings.shading;
    options.background = state.shown_background();
    options.background->transparent = chosen.transparent && judged.has_alpha;
    options.fit.given = state.camera;
    options.frames.turntable = form.turns() ? chosen.turntable : 0;
    options.frames.axis = chosen.axis;
    options.axes = chosen.marks && state.settings.axes_shown;
    options.scale_bar = chosen.marks && state.settings.scale_bar_shown;
    options.legend = chosen.marks && state.settings.legend_shown;
    if (judged.is_film) {
        options.film.movie = path;
        options.film.rate = chosen_rate(form, film_kind(path));
        if (judged.has_quality) options.film.quality = chosen.quality;
    } else {
        options.output = path;
    }
    request.is_of_file = form.takes_frames();
    if (request.is_of_file) request.changes = shared_edits_now(state);
    request.changes.light = state.shown_light();
    if (!request.is_of_file) {
        request.shown = scene_snapshot(state);
        const LookPanelState& look = state.side_panel.look;
        if (look.shown_revision == state.document.revision()) request.coloring = look.shown;
        return request;
    }
    options.frames.ranges = parse_frames(chosen.frames).value();
    const LoadOptions read = load_options(state, state.path, state.frame);
    options.data = read.data;
    options.data.all_properties = false;  // those of the look alone
    options.data.all_properties_up_to = 0;
    if (state.player.radius) options.data.radius = state.player.radius;
    options.look = read.look;
    return request;
}

void start_film(ViewerState& state, const FilmRequest& request) {
    const auto status = std::make_shared<FilmStatus>();
    const std::string path = request.options.film.movie
                                 ? *request.options.film.movie
                                 : fill_in(*request.options.output, {.name = name_in_patterns(request.options.scenes.front())});
    const auto done = [&state, request, path, status] { announce(state, words_when_done(request, path, *status)); };
    const auto fail = [&state, request, status](const std::string& why) {
        const std::string far = how_far(request, *status);
        report_error(state, "The film cannot be exported", far.empty() ? why : why + "\n\n" + far + ".");
    };
    try {
        BackgroundJob job([request, status](WorkControl& control) { make_film(request, control, *status); });
        state.filming.emplace(Work{.path = path,
                                   .job = std::move(job),
                                   .done = done,
                                   .fail = fail,
                                   .cancel =
                                       [&state, request, status] {
                                           const std::string far = how_far(request, *status);
                                           announce(state, far.empty() ? "Cancelled" : "Cancelled: " + far);
                                       },
                                   .words = [path, status] { return words_of(path, *status); },
                                   .stop = [status] { return status->give_up_film(); }});
    } catch (...) {
        fail(describe_current_exception().message);
    }
}

void cancel_film(ViewerState& state) {
    if (!state.filming || state.filming->job.ended()) return;
    state.filming->job.cancel();
    const bool may_appear = !state.filming->stop() && state.filming->job.control().writes;
    const Work cancelled = *std::exchange(state.filming, std::nullopt);
    if (may_appear) return announce(state, "Cancelled too late: the film may be written all the same");
    cancelled.cancel();
}

}  // namespace sphereview

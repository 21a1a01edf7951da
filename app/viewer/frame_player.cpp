#include "viewer/frame_player.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "formats/atoms.hpp"
#include "viewer/scene_file.hpp"
#include "viewer/scene_saving.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

KnownFrames known_frames(const ViewerState& state) { return {state.frames, state.player.all_frames}; }

// What reads the file as it is shown, or as it is now.
FramesAhead& source(ViewerState& state) {
    FramePlayer& player = state.player;
    LoadOptions options = load_options(state, state.path, 0);
    const bool same_file = player.ahead && (state.stamp == player.opened || state.stamp == player.shown);
    if (same_file && player.all_properties == state.all_properties) {
        player.ahead->set_look(options.look);
        return *player.ahead;
    }
    if (player.radius) options.data.radius = player.radius;
    player.shown = state.stamp;
    player.opened = file_states(state.path);
    player.all_properties = state.all_properties;
    player.ahead = std::make_unique<FramesAhead>(state.path, std::move(options));
    return *player.ahead;
}

// What is being read or written will change what the numbers of frames mean, or belongs to the frame that is shown.
bool waits_for_file(const ViewerState& state) { return state.saving || (state.loading && state.loading->path == state.path); }

// Once that frame is shown.
std::vector<std::int64_t> frames_behind(const ViewerState& state, std::int64_t frame) {
    const FramePlayer& player = state.player;
    if (player.clock.plays()) {
        return player.clock.next_ones(frame, player.choices.repeat, known_frames(state), FramesAhead::most_frames);
    }
    // Who steps once steps again.
    const std::int64_t next = frame + player.step;
    return player.step != 0 && has_frame(state, next) ? std::vector{next} : std::vector<std::int64_t>{};
}

void want(ViewerState& state, std::int64_t frame, bool by_clock) {
    FramePlayer& player = state.player;
    FramesAhead& ahead = source(state);
    const std::int64_t by = frame - state.frame;
    player.step = by == 1 || by == -1 ? by : 0;
    player.wanted = WantedFrame{frame, by_clock};
    std::vector<std::int64_t> frames = frames_behind(state, frame);
    frames.insert(frames.begin(), frame);
    ahead.want(std::move(frames));
}

// Calls `then` as soon as the edits may go that no other frame gets.
void with_own_edits_safe(ViewerState& state, const std::function<void()>& then) {
    const auto go_on = [&state, then] {
        state.player.given_up = state.document.revision();
        then();
    };
    if (!state.saving && reach_of_edits(state) != EditsReach::this_frame) return go_on();
    with_edits_safe(
        state, go_on,
        "Frame " + std::to_string(state.frame) + " of " + in_quotes(state.name()) +
            " has changes that no other frame gets, and that are not saved.\nColours, radii, names and what is hidden go along" +
            (has_numbers_of_file(state) ? "." : " only as they were before spheres were added, deleted or reordered here."));
}

bool may_leave_frame(ViewerState& state) {
    return reach_of_edits(state) != EditsReach::this_frame || state.player.given_up == state.document.revision();
}

PlayClock::Beat beat_of(double seconds) {
    return std::chrono::duration_cast<PlayClock::Beat>(std::chrono::duration<double>(seconds));
}

// Until that frame is to be shown behind the present one.
PlayClock::Beat beat_to(const ViewerState& state, std::int64_t frame) {
    constexpr double longest = 10.0;  // seconds: who waits longer takes the film for stopped
    const FramePlayer& player = state.player;
    const std::optional<double>& recorded = player.choices.speed.recorded;
    const double usual = 1.0 / frames_a_second(state);
    if (!recorded || !player.usual_step) return beat_of(usual);
    const std::int64_t by = frame - state.frame;
    const std::optional<double> time = player.ahead ? player.ahead->time_of(frame) : std::nullopt;
    // From the last frame to the first, or where a run has begun anew, the file does not say how long it takes.
    const double step = (by == 1 || by == -1) && time && player.time ? static_cast<double>(by) * (*time - player.time->value) : 0.0;
    return beat_of(step > 0.0 ? std::min(step / *recorded, longest) : usual);
}

// By the first frames beside the one that is shown whose times differ.
void note_usual_step(ViewerState& state) {
    FramePlayer& player = state.player;
    if (player.usual_step || !player.time || !player.ahead) return;
    for (const std::int64_t beside : {state.frame + 1, state.frame - 1}) {
        const double step = std::abs(player.ahead->time_of(beside).value_or(player.time->value) - player.time->value);
        if (step > 0.0 && std::isfinite(step) && !player.usual_step) player.usual_step = step;
    }
}

FrameNews stop(ViewerState& state) {
    state.player.clock.pause();
    state.player.wanted.reset();
    return FrameNews::stopped;
}

std::string words_of_fault(const WantedFrame& wanted) {
    if (wanted.passed_over < 2) return wanted.fault;
    return wanted.fault + "\nNor can " + in_groups(static_cast<std::uint64_t>(wanted.passed_over - 1)) + " more";
}

// The next one that way is wanted instead of a frame that cannot be read. Under the handle none is: it would slip away.
FrameNews pass_over(ViewerState& state, const std::string& fault) {
    FramePlayer& player = state.player;
    WantedFrame wanted = *player.wanted;
    if (wanted.fault.empty()) wanted.fault = "Frame " + std::to_string(wanted.frame) + " cannot be read: " + fault;
    if (player.choices.handle_held && !wanted.by_clock) {
        if (!player.wanted->fault.empty()) return FrameNews::none;
        player.wanted = wanted;
        announce(state, wanted.fault);
        return FrameNews::stopped;
    }
    ++wanted.passed_over;
    const std::optional<std::int64_t> next = wanted.by_clock
                                                 ? player.clock.step_from(wanted.frame, player.choices.repeat, known_frames(state))
                                                 : std::optional(wanted.frame + (wanted.frame > state.frame ? 1 : -1));
    if (!next && !player.all_frames) return FrameNews::none;  // until more are found
    if (next && has_frame(state, *next) && wanted.passed_over < state.frames) {
        want(state, *next, wanted.by_clock);
        player.wanted->passed_over = wanted.passed_over;
        player.wanted->fault = wanted.fault;
        return FrameNews::none;
    }
    player.wanted.reset();
    announce(state, words_of_fault(wanted));
    return wanted.by_clock ? stop(state) : FrameNews::stopped;
}

FrameNews show_wanted(ViewerState& state, PlayClock::Time now) {
    FramePlayer& player = state.player;
    const std::int64_t frame = player.wanted->frame;
    const bool plays = player.clock.plays();
    if (std::optional<LoadedScene> loaded = player.ahead->take(frame)) {
        const std::string passed_over = words_of_fault(*std::exchange(player.wanted, std::nullopt));
        if (!may_leave_frame(state)) {  // edited while it was read
            stop(state);
            with_own_edits_safe(state, [&state, frame, plays] {
                if (!has_frame(state, frame)) return;
                want(state, frame, plays);
                if (plays) state.player.clock.play(PlayClock::Time::clock::now());
            });
            return FrameNews::stopped;
        }
        const PlayClock::Beat beat = beat_to(state, frame);
        adopt_frame(state, frame, std::move(*loaded), player.opened, passed_over);
        player.clock.shown(beat, now);
        source(state).want(frames_behind(state, frame));
        return FrameNews::frame;
    }
    const std::optional<std::string> fault = player.ahead->fault_of(frame);
    if (fault && file_states(state.path) != state.stamp) {
        // The frame may be missing in what the file holds now, which is no fault: the film goes on from what is read again.
        player.wanted.reset();
        player.ahead.reset();
        look_at_file(state);
        return FrameNews::none;
    }
    if (!fault) {
        std::optional<PassedFrame> passed = player.ahead->take_passed();
        if (!passed || player.wanted->by_clock || !may_leave_frame(state)) return FrameNews::none;
        adopt_frame(state, passed->number, std::move(passed->loaded), player.opened);
        return FrameNews::frame;
    }
    if (!player.ahead->has_no_file()) return pass_over(state, *fault);
    stop(state);
    player.ahead.reset();
    report_error(state, "Frame " + std::to_string(frame) + " cannot be read", *fault);
    look_at_file(state);
    return FrameNews::stopped;
}

bool note_count(ViewerState& state) {
    FramePlayer& player = state.player;
    if (!player.ahead) return false;
    const FramesAhead::Count count = player.ahead->count();
    player.counted = count.part;
    const std::int64_t before = state.frames;
    if (count.all && count.frames > 0) state.frames = count.frames;
    // Of a file that has become shorter the frame that is shown stays one of them until it is read again.
    state.frames = std::max({state.frames, count.frames, state.frame + 1});
    if (player.all_frames || !count.all) return state.frames != before;
    player.all_frames = true;
    if (!count.fault.empty()) {
        announce(state, early_end(count.fault, state.frames));
    }
    return true;
}

FrameNews follow_clock(ViewerState& state, PlayClock::Time now, bool held) {
    FramePlayer& player = state.player;
    if (held) {
        player.clock.hold(now);
        return FrameNews::none;
    }
    if (now < next_frame_due(state)) return FrameNews::none;
    if (!may_leave_frame(state)) {
        stop(state);
        play_frames(state);  // asks
        return FrameNews::stopped;
    }
    const auto next = player.clock.step_from(state.frame, player.choices.repeat, known_frames(state));
    if (next) {
        want(state, *next, true);
    } else if (player.all_frames) {
        return stop(state);
    } else {
        player.clock.hold(now);  // until more are found
    }
    return FrameNews::none;
}

}  // namespace

bool has_several_frames(const ViewerState& state) { return !state.path.empty() && (state.frames > 1 || !state.player.all_frames); }

bool has_frame(const ViewerState& state, std::int64_t frame) { return !state.path.empty() && frame >= 0 && frame < state.frames; }

void begin_frames(ViewerState& state, const LoadedScene& loaded) {
    end_frames(state);
    state.frames = loaded.frames;
    state.player.all_frames = loaded.all_frames || state.path.empty();
    state.player.radius = loaded.radius_of_points;
    state.player.time = loaded.time;
    if (!state.player.all_frames) source(state);
    // How much time there is from frame to frame is to be known before it plays.
    if (loaded.time && has_frame(state, state.frame + 1)) source(state).want({state.frame + 1});
}

void end_frames(ViewerState& state) {
    const PlayChoices choices = state.player.choices;
    EditsBeyondReloads reloads = std::move(state.player.reloads);  // of the document's history, which stays
    state.player = {};
    state.player.reloads = std::move(reloads);
    state.player.choices = choices;
    state.player.choices.handle_held = false;
    state.player.choices.numbers = {};
    state.player.choices.time_letters = 0;
    state.frames = 1;
}

void show_frame(ViewerState& state, std::int64_t frame) {
    if (!has_frame(state, frame)) return;
    if (frame == state.frame) {
        state.player.wanted.reset();
        return;
    }
    with_own_edits_safe(state, [&state, frame] {
        if (!has_frame(state, frame) || frame == state.frame) return;  // saving may have made it another file
        want(state, frame, false);
        if (!is_read_at_once(state.path) || waits_for_file(state)) return;
        std::int64_t latest = -1;
        for (const FramePlayer& player = state.player; player.wanted && player.wanted->frame != latest;) {
            latest = player.wanted->frame;
            player.ahead->wait_for(latest);
            show_wanted(state, PlayClock::Time::clock::now());
        }
    });
}

void stop_at_frame(ViewerState& state, std::int64_t frame) {
    state.player.clock.pause();
    show_frame(state, frame);
}

void play_or_pause(ViewerState& state) {
    if (state.player.clock.plays()) {
        stop(state);
    } else {
        play_frames(state);
    }
}

void play_frames(ViewerState& state) {
    if (!has_several_frames(state)) return;
    with_own_edits_safe(state, [&state] {
        if (!has_several_frames(state)) return;
        FramePlayer& player = state.player;
        state.autosave.keep_before_reading(state.document, edited_file(state));
        player.clock.play(PlayClock::Time::clock::now());
        const bool at_end = player.all_frames && state.frame + 1 >= state.frames;
        if (at_end && player.choices.repeat == Repeat::once) return want(state, 0, true);
        source(state).want(frames_behind(state, state.frame));
    });
}

FrameNews follow_player(ViewerState& state, PlayClock::Time now, bool held) {
    FramePlayer& player = state.player;
    note_usual_step(state);
    FrameNews news = note_count(state) ? FrameNews::counted : FrameNews::none;
    const bool waits = waits_for_file(state) || !state.dialogs.empty();
    if (player.clock.plays() && !player.wanted) {
        const FrameNews clock = follow_clock(state, now, held || waits || player.choices.handle_held);
        if (clock != FrameNews::none) return clock;
    }
    if (!player.wanted || waits || (held && player.wanted->by_clock)) return news;
    const FrameNews shown = show_wanted(state, now);
    return shown == FrameNews::none ? news : shown;
}

double frames_a_second(const ViewerState& state) {
    const FramePlayer& player = state.player;
    const PlaySpeed& speed = player.choices.speed;
    return speed.recorded && player.usual_step ? *speed.recorded / *player.usual_step : speed.frames;
}

std::optional<PlayClock::Time> next_frame_due(const ViewerState& state) {
    const FramePlayer& player = state.player;
    if (!player.clock.plays() || player.wanted) return std::nullopt;
    const auto next = player.clock.next_ones(state.frame, player.choices.repeat, known_frames(state), 1);
    return player.clock.due(beat_to(state, next.empty() ? state.frame : next.front()));
}

bool reads_frames(const ViewerState& state) { return state.player.ahead && (state.player.wanted || !state.player.all_frames); }

TimelineFacts timeline_facts(ViewerState& state) {
    note_usual_step(state);
    const FramePlayer& player = state.player;
    TimelineFacts facts{player.clock.plays(),
                        player.wanted && !player.wanted->by_clock ? std::optional(player.wanted->frame) : std::nullopt,
                        !player.all_frames, player.counted, reach_of_edits(state)};
    facts.wanted_in_vain = player.wanted && player.wanted->passed_over == 0 && !player.wanted->fault.empty();
    if (player.time) {
        facts.time = player.time->text;
        facts.time_unit = player.time->unit;
        facts.usual_step = player.usual_step;
    }
    return facts;
}

}  // namespace sphereview

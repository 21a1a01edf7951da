#include "viewer/viewer.hpp"

#include <glad/gl.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.hpp"
#include "viewer/frame_player.hpp"
#include "viewer/perform.hpp"
#include "viewer/ray_drawing.hpp"
#include "viewer/scene_file.hpp"
#include "viewer/view_marks.hpp"

namespace sphereview {

namespace {

double seconds_between(Clock::time_point begin, Clock::time_point end) {
    return std::chrono::duration<double>(end - begin).count();
}

std::string title_for(const ViewerState& state) {
    return shown_text(state.name()) + (state.document.is_changed() ? " *" : "") + " - sphereview";
}

Theme theme_of(const ViewerSettings& settings) { return settings.light_theme ? Theme::light : Theme::dark; }

}  // namespace

Viewer::Viewer(ViewerState& state, Window& window)
    : state_(state),
      window_(window),
      imgui_(window, state.settings.text_scale, theme_of(state.settings)),
      picture_(state.options.shader_folder),
      log_(state.options.redraw_log),
      kept_recent_(load_settings().recent) {
    facts_.status.renderer = shown_text(window.renderer());
    state_.clipboard = {[&window] { return window.clipboard(); },
                        [&window](const std::string& text) { window.set_clipboard(text); }};
    state_.messages.shader_error = picture_.shader_log();
}

void Viewer::run(const std::function<bool()>& interrupted) {
    while (!state_.quits && !interrupted()) {
        if ((pacing_.rests() || pacing_.refines()) && input_.empty() && !plays() && autosaves()) {
            const std::lock_guard lock(state_.changing);
            state_.autosave.look(state_.document, edited_file(state_), Clock::now());
        }
        keep_recent_files();
        wait_for_work();
        if (is_between_frames()) continue;
        if (pacing_.refines() && input_.empty() && !refine_picture()) continue;
        if (!pacing_.rests() || !input_.empty()) redraw();
    }
    // What the end writes is not to be replaced by what was written before.
    if (settings_kept_) settings_kept_->wait_for(std::chrono::seconds(1));
}

bool Viewer::is_between_frames() const {
    constexpr std::chrono::milliseconds worth_refining{200};
    if (!plays() || !pacing_.is_settled() || !input_.empty()) return false;
    const auto due = next_frame_due(state_);
    return !due || *due < Clock::now() + worth_refining;
}

void Viewer::keep_recent_files() {
    if (state_.settings.recent == kept_recent_ || (settings_kept_ && !settings_kept_->ended())) return;
    kept_recent_ = state_.settings.recent;
    settings_kept_.reset();
    settings_kept_.emplace([settings = settings_to_keep(state_)](WorkControl&) { save_settings(settings); });
}

bool Viewer::plays() const { return state_.player.clock.plays(); }

// Not what is being saved: what is kept of that stays until the file is whole. But what is edited meanwhile.
bool Viewer::autosaves() const { return !state_.saving || state_.document.is_changed(); }

void Viewer::wait_for_work() {
    files_.watch({state_.path, state_.options.shader_folder});
    std::optional<double> patience = input_.empty() ? pacing_.patience() : 0.0;
    if (!patience) {
        for (const auto& time :
             {state_.announcement_ends, autosaves() ? state_.autosave.due() : std::nullopt, files_.next_look()}) {
            if (!time) continue;
            const double seconds = std::max(seconds_between(Clock::now(), *time), 0.0);
            patience = std::min(patience.value_or(seconds), seconds);
        }
    }
    if (const auto due = next_frame_due(state_)) {
        const double seconds = std::max(seconds_between(Clock::now(), *due), 0.0);
        patience = is_between_frames() ? seconds : std::min(patience.value_or(seconds), seconds);
    }
    const bool looks_again = is_working(state_) || reads_frames(state_) || rest_.works() || makes_rays(state_) ||
                             explains_beside(state_) || shaders_changed_;
    if (looks_again) patience = std::min(patience.value_or(Pacing::look_again), Pacing::look_again);
    if (state_.filming) patience = std::min(patience.value_or(film_shown_every), film_shown_every);
    std::vector<InputEvent> events = window_.wait_events(patience);
    if (!events.empty()) pacing_.touch();
    input_.add(std::move(events));

    for (const std::string& path : files_.look(Clock::now())) {
        const std::lock_guard lock(state_.changing);
        if (path == state_.path) {
            look_at_file(state_);
        } else {
            shaders_changed_ = true;
            // A driver's compiler may end the program.
            edits_kept_ = state_.autosave.keep_before_reading(state_.document, edited_file(state_));
        }
        pacing_.touch();
    }
    if (shaders_changed_ && (!edits_kept_ || edits_kept_->ended())) {
        shaders_changed_ = false;
        edits_kept_.reset();
        state_.messages.shader_error = picture_.reload_shaders();
        pacing_.touch();
    }
    follow_work();
    follow_frames();
    end_announcement();
}

void Viewer::follow_frames() {
    const FrameNews news = [&] {
        const std::lock_guard lock(state_.changing);
        return follow_player(state_, Clock::now(), in_hand_);
    }();
    if (news == FrameNews::frame && plays()) {
        pacing_.show_once();
    } else if (news == FrameNews::frame || news == FrameNews::stopped) {
        pacing_.touch();
    } else if (news == FrameNews::counted && (state_.player.all_frames || Clock::now() >= work_shown_ + work_shown_every)) {
        work_shown_ = Clock::now();
        pacing_.show_once();
    }
}

void Viewer::follow_work() {
    const bool ended = [&] {
        const std::lock_guard lock(state_.changing);
        return finish_work(state_);
    }();
    if (ended || (is_working(state_) && Clock::now() >= work_shown_ + work_shown_every)) {
        work_shown_ = Clock::now();
        pacing_.touch();
    }
    const RestView::News news = rest_.look(state_);
    if (news == RestView::News::end) pacing_.touch();
    if (news == RestView::News::draft) pacing_.show_once();
    if (take_rays(state_)) pacing_.touch();
    if (take_explained(state_)) pacing_.touch();
    state_.messages.work = work_of(state_);
    if (state_.filming.has_value() != state_.messages.film.has_value()) pacing_.touch();
    if (state_.filming && seconds_between(film_shown_, Clock::now()) >= film_shown_every) {
        film_shown_ = Clock::now();
        state_.messages.film = state_.filming->words();
        pacing_.show_once();
    }
    if (!state_.filming) state_.messages.film.reset();
}

void Viewer::end_announcement() {
    if (!state_.announcement_ends || Clock::now() < *state_.announcement_ends) return;
    state_.announcement_ends.reset();
    state_.messages.announcement.clear();
    pacing_.touch();
}

void Viewer::draw_rays_in_space() {
    if (!state_.rays.on) return;
    const SeenTexels seen = picture_.seen_texels();
    draw_rays(state_, facts_.inspection, facts_.seen_by_eye, {seen, area_, pixels_, imgui_.scale()});
}

bool Viewer::update_picture(int step, double patience) {
    if (!picture_.update(state_.document, {state_.camera, state_.picture_size}, step, state_.settings.shading, state_.shown_light(),
                         patience))
        return false;
    pacing_.traced(picture_.step(), picture_.last_seconds(), picture_.last_drawing_seconds());
    return true;
}

bool Viewer::refine_picture() {
    const int before = picture_.step();
    // A very coarse picture is first refined to every 4th pixel, which takes little time beside the fine picture.
    update_picture(before > 8 ? 4 : 1, Pacing::refine_budget);
    if (picture_.step() != before || before == 1) return true;
    pacing_.refined_a_part();
    return false;
}

void Viewer::redraw() {
    const auto begin = Clock::now();
    const Window::Extent framebuffer = window_.framebuffer();
    if (framebuffer.width == 0 || framebuffer.height == 0) {  // minimised
        input_.take();
        pacing_.drew(1);
        return;
    }
    std::vector<Action> actions;
    facts_.keys = {};
    const std::vector<InputEvent> events = routing_.take(input_, facts_.keys, actions);
    imgui_.begin_redraw(events, seconds_between(last_redraw_, begin), has_popped_up(state_));
    // The box that is typed into loses the keyboard, and gives what it holds, before a save or a quit could miss that.
    if (routing_.waits_for_typing()) ImGui::SetWindowFocus(nullptr);
    widgets_.clear();
    facts_.difference = difference_.follow(state_.comparison ? state_.comparison->shown() : nullptr);
    facts_.seen_by_eye = seen_by_eye_.follow(state_.rays.picture.made());
    if (!ImGui::IsAnyItemActive() && !mouse_.is_dragging()) update_bounds(state_);

    if (!pointer_in_picture_) state_.hovered.reset();  // the list may say otherwise
    const std::vector<CommandInfo> commands = commands_of(state_);
    const PanelContext context{state_.document,
                               state_.selection,
                               state_.bounds,
                               commands,
                               imgui_.scale(),
                               state_.gesture,
                               state_.hovered,
                               actions,
                               log_.wanted() ? &widgets_ : nullptr,
                               state_.frame,
                               state_.frames,
                               state_.shown_light(),
                               camera_axes(state_.camera),
                               state_.inspected_camera(),
                               state_.property_names};
    in_hand_ = (mouse_.is_dragging() && !mouse_.moves_camera()) || (ImGui::IsAnyItemActive() && !state_.player.choices.handle_held);
    const bool asked = !state_.dialogs.empty();
    {
        const std::lock_guard lock(state_.changing);  // for the answers of dialogs
        area_ = draw_panels(state_, context, facts_);
    }
    draw_export_area(state_, area_);
    pixels_ = window_.extent().width > 0 ? static_cast<double>(framebuffer.width) / window_.extent().width : 1.0;
    state_.picture_size = {std::max(static_cast<int>(std::lround(area_.width * pixels_)), 1),
                           std::max(static_cast<int>(std::lround(area_.height * pixels_)), 1)};
    // The rays are drawn last, over the picture that is shown then, and yet lie below the marks.
    ImDrawList& over_picture = *ImGui::GetBackgroundDrawList();
    over_picture.ChannelsSplit(2);
    over_picture.ChannelsSetCurrent(1);
    draw_view_marks(state_, context, area_, pixels_);
    draw_measured(state_, context, area_, pixels_);
    use_mouse(context, facts_.keys.escape);
    draw_pointer_marks(state_, mouse_, area_, pixels_, imgui_.scale());
    if (facts_.keys.escape && state_.announcement_ends) state_.announcement_ends = begin;
    if (facts_.keys.escape && !asked) {
        const std::lock_guard lock(state_.changing);
        cancel_work(state_);
    }

    {
        const std::lock_guard lock(state_.changing);
        perform(state_, std::move(actions));
        perform(state_, routing_.take_after_typing());
    }
    give_seen();
    const bool searches = state_.panel_drawn && !state_.side_panel.search.done();
    if (fly_on(state_, begin) || state_.rays.flies || searches) pacing_.touch();
    window_.set_title(title_for(state_));

    rest_.settle(state_);
    const bool traced = update_picture(pacing_.moving_step(), pacing_.budget());
    note_facts();
    follow_rays(state_);
    over_picture.ChannelsSetCurrent(0);
    draw_rays_in_space();  // over the picture that is shown now, whose spheres hide them
    over_picture.ChannelsMerge();
    const bool panels_changed = imgui_.end_redraw();
    imgui_.set_text_scale(state_.settings.text_scale);
    imgui_.set_theme(theme_of(state_.settings));
    show(area_);
    imgui_.render();
    window_.swap_buffers();
    pacing_.drew(picture_.step(), panels_changed);
    if (!plays()) {
        pacing_.end_play();
    } else if (traced) {
        constexpr double soon_enough = 10.0;  // frames a second
        pacing_.play(seconds_between(begin, Clock::now()) - picture_.last_seconds(), frames_a_second(state_) >= soon_enough);
    }
    const bool rests = pacing_.rests() && input_.empty() && !plays();
    if (lost_hint_.update(state_, picture_, rests)) pacing_.touch();
    rest_.end_redraw(state_, picture_, rests);
    if (log_.wanted()) {
        const bool resting = rests && !is_working(state_) && !reads_frames(state_) && !rest_.works() && !makes_rays(state_) &&
                             !explains_beside(state_);
        log_.add(state_, facts_,
                 {++redraw_number_, picture_.builds(), explanations_, rest_.is_exact(), rest_.works(), rest_.draft_seconds(state_),
                  resting, area_, seconds_between(begin, Clock::now()), title_for(state_)},
                 widgets_);
    }
    // Input waits while a redraw goes on: the rest of a slow one does not make a double click too slow.
    constexpr std::chrono::milliseconds most_counted{50};
    last_redraw_ = std::max(begin, Clock::now() - most_counted);
}

void Viewer::give_seen() {
    LookPanelState& look = state_.side_panel.look;
    if (!look.asks_for_seen) return;
    std::vector<std::uint32_t> seen;
    for (const std::int32_t number : picture_.seen_texels().numbers) {
        if (number >= 0) seen.push_back(static_cast<std::uint32_t>(number));
    }
    std::ranges::sort(seen);
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    look.seen = std::move(seen);
    look.asks_for_seen = false;
    pacing_.touch();
}

void Viewer::show(const Rectangle& area) {
    const bool finished = rest_.upload(state_, picture_);
    const Window::Extent framebuffer = window_.framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    // Where neither the picture nor a panel draws, nothing of an earlier redraw shows through.
    const ImVec4 around = ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);
    glClearColor(around.x, around.y, around.z, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    const int left = static_cast<int>(std::lround(area.x * pixels_));
    const int top = static_cast<int>(std::lround(area.y * pixels_));
    const PictureSize size = state_.picture_size;
    picture_.show({left, framebuffer.height - top - size.height, size.width, size.height}, state_.shown_background(),
                  {&state_.selection, state_.hovered, static_cast<float>(2.0 * static_cast<double>(imgui_.scale()) * pixels_)},
                  finished);
}

}  // namespace sphereview

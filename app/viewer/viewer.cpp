#include "viewer/viewer.hpp"

#include <glad/gl.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "base/text.hpp"
#include "viewer/perform.hpp"
#include "viewer/ray_drawing.hpp"
#include "viewer/scene_file.hpp"

namespace sphereview {

namespace {

double seconds_between(Clock::time_point begin, Clock::time_point end) {
    return std::chrono::duration<double>(end - begin).count();
}

// A key that is typed into a field is not a shortcut; one with Ctrl, and a function key, is, unless the field edits with it.
bool is_typed(const KeyChanged& key) {
    if (key.modifiers.alt) return false;
    if (key.modifiers.control) {
        for (const char* editing : {"a", "c", "v", "x", "z", "y", "left", "right", "home", "end", "backspace", "delete"}) {
            if (key.name == editing) return true;
        }
        return false;
    }
    const bool function_key = key.name.size() > 1 && key.name[0] == 'f' && key.name[1] >= '1' && key.name[1] <= '9';
    return !function_key;
}

// Keys that go through the list of spheres while it has them.
bool scrolls_list(const KeyChanged& key) {
    if (key.modifiers.control || key.modifiers.alt) return false;
    return key.name == "home" || key.name == "end" || key.name == "page up" || key.name == "page down";
}

void note_dialog_key(const KeyChanged& key, bool typing, DialogKeys& keys) {
    if (key.name == "enter" && !key.repeated) keys.enter = true;
    if (key.name == "escape" && !key.repeated) keys.escape = true;
    if (typing) return;
    if (key.name == "right" || (key.name == "tab" && !key.modifiers.shift)) keys.step = 1;
    if (key.name == "left" || (key.name == "tab" && key.modifiers.shift)) keys.step = -1;
}

// Whether the person begins something: then the view moves by itself no longer.
bool takes_over(const InputEvent& event) {
    if (const auto* key = std::get_if<KeyChanged>(&event)) return key->pressed;
    if (const auto* button = std::get_if<ButtonChanged>(&event)) return button->pressed;
    return std::holds_alternative<WheelTurned>(event);
}

// A menu or a colour picker is open. Dialogs have keys of their own.
bool has_popped_up(const ViewerState& state) { return state.dialogs.empty() && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup); }

std::string title_for(const ViewerState& state) {
    return shown_text(state.name()) + (state.document.is_changed() ? " *" : "") + " - sphereview";
}

Theme theme_of(const ViewerSettings& settings) { return settings.light_theme ? Theme::light : Theme::dark; }

std::optional<WorkShown> work_of(const ViewerState& state) {
    if (state.saving) return WorkShown{"Saving " + state.saving->path, {}, false};
    if (!state.loading && !state.exporting) {
        if (!state.comparing) return {};
        return WorkShown{"Comparing " + state.comparing->path, {}, true};
    }
    const WorkControl& control = state.loading ? state.loading->job.control() : state.exporting->job.control();
    const double done = static_cast<double>(control.done);
    const double total = static_cast<double>(control.total);
    if (!state.loading) {
        return WorkShown{"Exporting " + state.exporting->shown_path(), total > 0.0 ? done / total : 0.0, true};
    }
    std::string text = "Reading " + state.loading->path + ": " + fixed(1e-6 * done, 0);
    if (total > 0.0) text += " of " + fixed(1e-6 * total, 0);
    return WorkShown{text + " MB", total > 0.0 ? std::optional(std::min(done / total, 1.0)) : std::nullopt, true};
}

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
        if (pacing_.rests() && input_.empty() && autosaves()) {
            const std::lock_guard lock(state_.changing);
            state_.autosave.look(state_.document, state_.path, Clock::now());
        }
        keep_recent_files();
        wait_for_work();
        if (!pacing_.rests() || !input_.empty()) redraw();
    }
    // What the end writes is not to be replaced by what was written before.
    if (settings_kept_) settings_kept_->wait_for(std::chrono::seconds(1));
}

void Viewer::keep_recent_files() {
    if (state_.settings.recent == kept_recent_ || (settings_kept_ && !settings_kept_->ended())) return;
    kept_recent_ = state_.settings.recent;
    settings_kept_.reset();
    settings_kept_.emplace([settings = state_.settings](WorkControl&) { save_settings(settings); });
}

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
    const bool looks_again = is_working(state_) || rest_.works() || makes_rays(state_) || state_.box_selection || shaders_changed_;
    if (looks_again) patience = std::min(patience.value_or(Pacing::look_again), Pacing::look_again);
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
            edits_kept_ = state_.autosave.keep_before_reading(state_.document, state_.path);
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
    end_announcement();
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
    if (finish_box_selection(state_)) pacing_.touch();
    if (take_rays(state_)) pacing_.touch();
    state_.messages.work = work_of(state_);
}

void Viewer::end_announcement() {
    if (!state_.announcement_ends || Clock::now() < *state_.announcement_ends) return;
    state_.announcement_ends.reset();
    state_.messages.announcement.clear();
    pacing_.touch();
}

bool Viewer::is_escape_for_another(bool typing, bool popped_up, DialogKeys& keys) {
    if (!state_.dialogs.empty() || mouse_.is_dragging()) return true;
    if (popped_up || typing || ImGui::IsAnyItemActive()) {
        keys.escape = false;  // ImGui's
        return true;
    }
    if (state_.help_shown) {
        state_.help_shown = false;
        keys.escape = false;
        return true;
    }
    if (state_.about.shown) {
        state_.about.shown = false;
        keys.escape = false;
        return true;
    }
    if (state_.loading || state_.exporting || state_.comparing) return true;
    if (let_go(state_.pins)) {
        keys.escape = false;
        return true;
    }
    if (!state_.measuring.on && !state_.rays.on) return false;
    if (state_.measuring.on) {
        state_.measuring = {};
    } else {
        end_rays(state_);
    }
    keys.escape = false;
    return true;
}

bool Viewer::is_lone_alt(const InputEvent& event) {
    const auto* key = std::get_if<KeyChanged>(&event);
    if (key != nullptr && key->name == "alt" && !key->pressed) return std::exchange(alt_alone_, false);
    if (key != nullptr && key->pressed) {
        alt_alone_ = key->name == "alt" && !key->modifiers.control && !key->modifiers.shift;
    } else if (!std::holds_alternative<PointerMoved>(event)) {
        alt_alone_ = false;
    }
    return false;
}

std::vector<InputEvent> Viewer::take_events(DialogKeys& keys, std::vector<Action>& actions) {
    const bool typing = ImGui::GetIO().WantTextInput;
    // What follows a click on a number, or the key that saves a view, is meant for the box that opens. In a panel that is not drawn
    // none does.
    const SidePanelState& panel = state_.side_panel;
    const bool opens = state_.panel_shown && (panel.opens_box() || (panel.has_box() && !typing));
    waited_for_box_ = opens ? waited_for_box_ + 1 : 0;
    std::vector<InputEvent> events = input_.take_frame(opens && waited_for_box_ <= longest_wait_for_box);
    if (!events.empty()) pacing_.touch();
    const bool popped_up = has_popped_up(state_);
    const std::vector<CommandInfo> commands = commands_of(state_);
    for (const InputEvent& event : events) {
        if (takes_over(event)) state_.flight.reset();
        if (is_lone_alt(event) && state_.dialogs.empty() && !popped_up) state_.menu_keys.begins = true;
        if (std::holds_alternative<CloseRequested>(event)) {
            (typing ? after_typing_ : actions).emplace_back(RunCommand{CommandId::quit});
        } else if (const auto* dropped = std::get_if<FilesDropped>(&event)) {
            actions.emplace_back(OpenFile{dropped->paths.front()});
        } else if (const auto* key = std::get_if<KeyChanged>(&event); key != nullptr && key->pressed) {
            note_dialog_key(*key, typing, keys);
            if (key->name == "escape" && is_escape_for_another(typing, popped_up, keys)) continue;
            if (popped_up && key->name == "right") state_.menu_keys.step = 1;
            if (popped_up && key->name == "left") state_.menu_keys.step = -1;
            if (popped_up && !key->modifiers.control) continue;
            if (!state_.dialogs.empty() || mouse_.is_dragging() || (typing && is_typed(*key))) continue;
            if (state_.panel_shown && state_.side_panel.list_has_keys && scrolls_list(*key)) continue;
            const Modifiers& m = key->modifiers;
            if (const auto command = command_for_key(commands, key->name, m.control, m.shift, m.alt))
                (typing ? after_typing_ : actions).emplace_back(RunCommand{*command});
        } else if (const auto* typed = std::get_if<CharacterTyped>(&event);
                   typed != nullptr && !typing && !popped_up && state_.dialogs.empty()) {
            if (const auto command = command_for_character(commands, typed->character)) actions.emplace_back(RunCommand{*command});
        }
    }
    // Between the menus of the bar the keyboard goes by menu_keys; ImGui 1.86 would close them on its way.
    const bool steps_menus = popped_up && !state_.menu_keys.open.empty() && !state_.menu_keys.in_submenu;
    std::erase_if(events, [&](const InputEvent& event) {
        const auto* key = std::get_if<KeyChanged>(&event);
        return steps_menus && key != nullptr && key->pressed && (key->name == "left" || key->name == "right");
    });
    return events;
}

std::optional<Pixel> Viewer::pixel_under_pointer() const {
    const ImVec2 at = ImGui::GetIO().MousePos;
    const double x = (static_cast<double>(at.x) - static_cast<double>(area_.x)) * pixels_;
    const double y = (static_cast<double>(at.y) - static_cast<double>(area_.y)) * pixels_;
    if (!(x >= 0.0 && y >= 0.0 && x < state_.picture_size.width && y < state_.picture_size.height)) return std::nullopt;
    return Pixel{static_cast<int>(x), static_cast<int>(y)};
}

void Viewer::use_mouse(const PanelContext& context, bool cancelled) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto pixel = pixel_under_pointer();
    pointer_in_picture_ = pixel && !io.WantCaptureMouse && state_.dialogs.empty();
    PictureMouse mouse;
    mouse.place = {(static_cast<double>(io.MousePos.x) - static_cast<double>(area_.x)) * pixels_,
                   (static_cast<double>(io.MousePos.y) - static_cast<double>(area_.y)) * pixels_};
    mouse.available = pointer_in_picture_;
    for (int button = 0; button < 3; ++button) {
        mouse.pressed[static_cast<std::size_t>(button)] = ImGui::IsMouseClicked(button);
        mouse.released[static_cast<std::size_t>(button)] = !io.MouseDown[button];
    }
    mouse.double_clicked = ImGui::IsMouseDoubleClicked(0);
    mouse.wheel = static_cast<double>(io.MouseWheel);
    mouse.control = io.KeyCtrl;
    mouse.shift = io.KeyShift;
    mouse.cancelled = cancelled;
    mouse.drag_threshold = 4.0 * static_cast<double>(imgui_.scale()) * pixels_;

    const auto pick = [this](glm::dvec2 place) {
        const Pixel at{std::clamp(static_cast<int>(place.x), 0, state_.picture_size.width - 1),
                       std::clamp(static_cast<int>(place.y), 0, state_.picture_size.height - 1)};
        return picture_.pick(state_.document, at);
    };
    const PictureState picture{
        state_.scene(),
        state_.selection,
        state_.camera,
        state_.picture_size,
        state_.pivot,
        pick,
        [this](Pixel low, Pixel high, bool toggles) {
            select_seen(state_, {low.x, low.y, high.x - low.x + 1, high.y - low.y + 1}, toggles);
        },
        state_.bounds,
        state_.settings.trackball,
        state_.measuring.on,
        middle_of_rays(state_),
        [&](glm::dvec2 place) { return state_.rays.on && eye_pixel_at(state_, place, pick(place), true).has_value(); }};
    const PictureConsequences done = mouse_.frame(mouse, picture, state_.gesture, context.actions);
    if (done.camera && *done.camera != state_.camera) state_.camera = *done.camera;
    if (done.pivot) state_.pivot = *done.pivot;
    if (done.clicked && state_.has_pins()) pin_clicked(*done.clicked, mouse.shift);
}

std::optional<PinnedPixel> Viewer::pointed_pixel(const std::optional<Pixel>& pixel,
                                                 const std::optional<std::uint32_t>& sphere) const {
    if (state_.rays.on && state_.rays.pointed) return state_.rays.pointed;
    if (!pixel) return std::nullopt;
    if (!state_.rays.on) return PinnedPixel{*pixel, state_.picture_size};
    if (state_.flight || mouse_.is_dragging()) return std::nullopt;
    return eye_pixel_at(state_, {pixel->x + 0.5, pixel->y + 0.5}, sphere ? static_cast<std::int32_t>(*sphere) : visible_background);
}

void Viewer::pin_clicked(const glm::dvec2& place, bool beside) {
    const Pixel pixel{static_cast<int>(place.x), static_cast<int>(place.y)};
    const std::optional<PinnedPixel> meant = state_.rays.on ? eye_pixel_at(state_, place, picture_.pick(state_.document, pixel))
                                                            : PinnedPixel{pixel, state_.picture_size};
    if (meant) pin(state_.pins, *meant, beside);
}

void Viewer::draw_rays_in_space() {
    if (!state_.rays.on) return;
    const SeenTexels seen = picture_.seen_texels();
    draw_rays(state_, facts_.inspection, facts_.seen_by_eye, {seen, area_, pixels_, imgui_.scale()});
}

void Viewer::update_picture(int step) {
    if (!picture_.update(state_.document, {state_.camera, state_.picture_size}, step, state_.settings.shading,
                         state_.shown_light()))
        return;
    pacing_.traced(picture_.step(), picture_.last_seconds(), picture_.last_drawing_seconds());
}

ImVec2 Viewer::on_screen(const glm::dvec2& place) const {
    return {static_cast<float>(area_.x + place.x / pixels_), static_cast<float>(area_.y + place.y / pixels_)};
}

void Viewer::draw_orbit_point() const {
    const auto point = mouse_.turns_about();
    if (!point) return;
    const auto place = place_of(state_.camera, state_.picture_size, *point);
    if (place) draw_cross(area_, on_screen(*place), imgui_.scale());
}

void Viewer::draw_pins() const {
    if (!state_.inspector_shown || state_.rays.on) return;
    for (const auto& [pixel, name] : {std::pair{&state_.pins.first, "1"}, std::pair{&state_.pins.second, "2"}}) {
        if (!*pixel) continue;
        draw_pin(area_, on_screen(place_in(state_.picture_size, **pixel)), imgui_.scale(), state_.pins.second ? name : "");
    }
}

void Viewer::draw_box() const {
    const auto box = mouse_.box();
    if (!box) return;
    draw_frame(area_, on_screen(glm::min(box->from, box->to)), on_screen(glm::max(box->from, box->to)), 160, 220, 40);
}

void Viewer::redraw() {
    const auto begin = Clock::now();
    const Window::Extent framebuffer = window_.framebuffer();
    if (framebuffer.width == 0 || framebuffer.height == 0) {  // minimised
        input_.take_frame();
        pacing_.drew(1);
        return;
    }
    std::vector<Action> actions;
    const bool refines = pacing_.refines();
    facts_.keys = {};
    const std::vector<InputEvent> events = take_events(facts_.keys, actions);
    imgui_.begin_frame(events, seconds_between(last_redraw_, begin), has_popped_up(state_));
    // The box that is typed into loses the keyboard, and gives what it holds, before a save or a quit could miss that.
    if (!after_typing_.empty()) ImGui::SetWindowFocus(nullptr);
    widgets_.clear();
    facts_.difference = difference_.follow(state_.comparison ? state_.comparison->difference : nullptr);
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
                               state_.camera};
    const bool asked = !state_.dialogs.empty();
    {
        const std::lock_guard lock(state_.changing);  // for the answers of dialogs
        area_ = draw_panels(state_, context, facts_);
    }
    draw_export_area(state_, area_);
    pixels_ = window_.extent().width > 0 ? static_cast<double>(framebuffer.width) / window_.extent().width : 1.0;
    state_.picture_size = {std::max(static_cast<int>(std::lround(area_.width * pixels_)), 1),
                           std::max(static_cast<int>(std::lround(area_.height * pixels_)), 1)};
    draw_view_marks(state_, context, area_, pixels_);
    draw_measured(state_, context, area_, pixels_);
    use_mouse(context, facts_.keys.escape);
    draw_box();
    draw_orbit_point();
    draw_pins();
    if (facts_.keys.escape && state_.announcement_ends) state_.announcement_ends = begin;
    if (facts_.keys.escape && !asked) {
        const std::lock_guard lock(state_.changing);
        cancel_work(state_);
    }

    {
        const std::lock_guard lock(state_.changing);
        perform(state_, std::move(actions));
        perform(state_, std::exchange(after_typing_, {}));
    }
    const bool searches = state_.panel_shown && !state_.side_panel.search.done();
    if (fly_on(state_, begin) || !state_.rays.to_see.empty() || searches) pacing_.touch();
    window_.set_title(title_for(state_));

    rest_.settle(state_);
    update_picture(refines ? 1 : pacing_.moving_step());
    note_facts();
    follow_rays(state_);
    draw_rays_in_space();  // over the picture that is shown now, whose spheres hide them
    imgui_.end_frame();
    imgui_.set_text_scale(state_.settings.text_scale);
    imgui_.set_theme(theme_of(state_.settings));
    show(area_);
    imgui_.render();
    window_.swap_buffers();
    pacing_.drew(picture_.step());
    if (lost_hint_.update(state_, picture_, pacing_.rests() && input_.empty())) pacing_.touch();
    rest_.end_redraw(state_, picture_, pacing_.rests() && input_.empty());
    if (log_.wanted()) {
        const bool resting = pacing_.rests() && input_.empty() && !is_working(state_) && !rest_.works() && !makes_rays(state_) &&
                             !state_.box_selection;
        log_.add(state_, facts_,
                 {++redraw_number_, picture_.builds(), explanations_, rest_.is_exact(), rest_.works(), rest_.draft_seconds(state_),
                  resting, area_, seconds_between(begin, Clock::now()), title_for(state_)},
                 widgets_);
    }
    // Input waits while a redraw goes on: the rest of a slow one does not make a double click too slow.
    constexpr std::chrono::milliseconds most_counted{50};
    last_redraw_ = std::max(begin, Clock::now() - most_counted);
}

void Viewer::note_facts() {
    const std::optional<Pixel> pixel = pointer_in_picture_ ? pixel_under_pointer() : std::nullopt;
    std::optional<std::uint32_t> sphere;
    // While the view moves nothing is looked for under the pointer: in a coarse picture of a million spheres that takes as long as
    // a fifth of a frame.
    if (mouse_.moves_camera()) {
        state_.hovered.reset();
    } else if (pixel) {
        const std::int32_t picked = picture_.pick(state_.document, *pixel);
        if (picked >= 0) sphere = static_cast<std::uint32_t>(picked);
        if (state_.hovered != sphere) pacing_.touch();
        state_.hovered = sphere;
    }
    facts_.status = {facts_.status.renderer, picture_.last_seconds(), picture_.step(), pixel, state_.picture_size, sphere};
    // A text field stays active when nothing moves; what is dragged in a panel has the button down.
    const bool drags = mouse_.is_dragging() || (ImGui::IsAnyItemActive() && ImGui::IsMouseDown(0));
    const std::size_t explained =
        inspect(state_, picture_, pointed_pixel(pixel, sphere), drags || state_.flight, facts_.inspection);
    explanations_ += explained;
    if (explained > 0) pacing_.touch();  // the panels of this redraw are drawn already
}

void Viewer::show(const Rectangle& area) {
    const bool finished = rest_.upload(state_, picture_);
    const Window::Extent framebuffer = window_.framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    const int left = static_cast<int>(std::lround(area.x * pixels_));
    const int top = static_cast<int>(std::lround(area.y * pixels_));
    const PictureSize size = state_.picture_size;
    picture_.show({left, framebuffer.height - top - size.height, size.width, size.height}, state_.shown_background(),
                  {&state_.selection, state_.hovered, static_cast<float>(2.0 * static_cast<double>(imgui_.scale()) * pixels_)},
                  finished);
}

}  // namespace sphereview

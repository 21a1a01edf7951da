#include "viewer/event_routing.hpp"

#include <imgui.h>

#include "viewer/perform.hpp"

namespace sphereview {

namespace {

constexpr int longest_wait_for_box = 8;  // redraws

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

}  // namespace

bool has_popped_up(const ViewerState& state) { return state.dialogs.empty() && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup); }

bool EventRouting::is_escape_for_another(bool typing, bool popped_up, DialogKeys& keys) {
    if (!state_.dialogs.empty() || mouse_.is_dragging()) return true;
    if (popped_up || typing || ImGui::IsAnyItemActive()) {
        keys.escape = false;  // ImGui's
        return true;
    }
    // Work is cancelled by others, and only where nothing of these is above it.
    const bool closed = std::exchange(state_.help_shown, false) || std::exchange(state_.about.shown, false);
    if (!closed && (state_.loading || state_.exporting || state_.comparing)) return true;
    if (closed || (state_.comparison && std::exchange(state_.comparison->view.open, false)) || let_go(state_.pins) ||
        std::exchange(state_.measuring, {}).on) {
        keys.escape = false;
        return true;
    }
    if (!state_.rays.on) return false;
    end_rays(state_);
    keys.escape = false;
    return true;
}

bool EventRouting::is_of_list(const KeyChanged& key) const {
    return state_.panel_drawn && state_.side_panel.list_has_keys && scrolls_list(key);
}

bool EventRouting::is_lone_alt(const InputEvent& event) {
    const auto* key = std::get_if<KeyChanged>(&event);
    if (key != nullptr && key->name == "alt" && !key->pressed) return std::exchange(alt_alone_, false);
    if (key != nullptr && key->pressed) {
        alt_alone_ = key->name == "alt" && !key->modifiers.control && !key->modifiers.shift;
    } else if (!std::holds_alternative<PointerMoved>(event)) {
        alt_alone_ = false;
    }
    return false;
}

std::vector<InputEvent> EventRouting::take(InputQueue& input, DialogKeys& keys, std::vector<Action>& actions) {
    const bool typing = ImGui::GetIO().WantTextInput;
    // What follows a click on a number, or the key that saves a view, is meant for the box that opens. In a panel that is not drawn
    // none does.
    const SidePanelState& panel = state_.side_panel;
    const NumberFields& frame = state_.player.choices.numbers;
    const bool opens = (state_.panel_drawn && (panel.opens_box() || (panel.has_box() && !typing))) || frame.focus ||
                       (!frame.typed.empty() && !typing);
    waited_for_box_ = opens ? waited_for_box_ + 1 : 0;
    const bool popped_up = has_popped_up(state_);
    const std::vector<CommandInfo> commands = commands_of(state_);
    // Each press goes a frame further, however many there are.
    const auto adds_up = [&](const KeyChanged& key) {
        if (typing || popped_up || !state_.dialogs.empty() || is_of_list(key)) return false;
        const auto command = command_for_key(commands, key.name, key.modifiers.control, key.modifiers.shift, key.modifiers.alt);
        return command == CommandId::next_frame || command == CommandId::previous_frame;
    };
    std::vector<InputEvent> events = input.take(opens && waited_for_box_ <= longest_wait_for_box, adds_up);
    if (!events.empty()) pacing_.touch();
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
            if (is_of_list(*key)) continue;
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

}  // namespace sphereview

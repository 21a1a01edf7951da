#include "viewer/input_queue.hpp"

#include <algorithm>
#include <iterator>

namespace sphereview {

namespace {

bool is_modifier(const std::string& key) { return key == "shift" || key == "control" || key == "alt"; }

// A letter, digit or sign that is typed: ImGui gets the character and does not ask whether the key is down.
bool is_plain(const KeyChanged& key) { return key.name.size() == 1 && !key.modifiers.control && !key.modifiers.alt; }

// What a redraw has taken so far.
struct Taken {
    const InputQueue::AddsUp& adds_up;
    bool moved = false;
    bool button = false;
    bool wheel = false;
    bool key_that_edits = false;  // "backspace" and the like: a text field takes the redraw's characters before its keys
    bool characters = false;
    std::vector<std::string> keys{};
    Modifiers modifiers{};

    // Whether the event would hide what was taken; if not, it is taken.
    bool hides(const InputEvent& event) {
        return std::visit([&](const auto& e) { return hidden_by(e); }, event);
    }

private:
    bool hidden_by(const PointerMoved&) {
        moved = true;
        return button || wheel;
    }
    bool hidden_by(const ButtonChanged& event) {
        // A drag is seen only while the button is held.
        const bool hides = button || wheel || (moved && !event.pressed);
        button = true;
        return hides;
    }
    // Turns one after the other add up.
    bool hidden_by(const WheelTurned&) {
        wheel = true;
        return button;
    }
    bool hidden_by(const KeyChanged& event) {
        const bool seen = std::ranges::find(keys, event.name) != keys.end() && !(adds_up && adds_up(event));
        const bool other_modifiers = !keys.empty() && event.modifiers != modifiers;
        // What the mouse did before a modifier changed was done without that change.
        const bool for_mouse = (moved || button || wheel) && is_modifier(event.name);
        // A key is no shortcut during a drag, and what a button does is done at the end of its redraw.
        const bool after_button = event.pressed && button;
        // What another key opens, such as a text box, must be there before a letter comes.
        if (is_plain(event)) return other_modifiers || after_button || (event.pressed && key_that_edits);
        if (seen || other_modifiers || for_mouse || after_button || (event.pressed && characters)) return true;
        keys.push_back(event.name);
        modifiers = event.modifiers;
        key_that_edits = key_that_edits || (event.pressed && event.name.size() > 1);
        return false;
    }
    bool hidden_by(const CharacterTyped&) {
        characters = true;
        return key_that_edits;
    }
    bool hidden_by(const auto&) const { return false; }
};

// A held key's repeat in the redraw that has the key already. The person holds a key until enough has happened; what slow redraws
// have not shown yet would come on top of that.
bool is_repeat_of(const std::vector<InputEvent>& portion, const InputEvent& event) {
    const auto* key = std::get_if<KeyChanged>(&event);
    if (key == nullptr || !key->pressed || !key->repeated || is_plain(*key)) return false;
    for (auto earlier = portion.rbegin(); earlier != portion.rend(); ++earlier) {
        const auto* other = std::get_if<KeyChanged>(&*earlier);
        if (other != nullptr && other->name == key->name) return other->pressed && other->modifiers == key->modifiers;
    }
    return false;
}

}  // namespace

void InputQueue::add(std::vector<InputEvent> events) {
    events_.insert(events_.end(), std::make_move_iterator(events.begin()), std::make_move_iterator(events.end()));
}

std::vector<InputEvent> InputQueue::take(bool keys_wait, const AddsUp& adds_up) {
    Taken taken{.adds_up = adds_up};
    const auto is_typed = [](const InputEvent& event) {
        const auto* key = std::get_if<KeyChanged>(&event);
        return (key != nullptr && key->pressed) || std::holds_alternative<CharacterTyped>(event);
    };
    std::vector<InputEvent> portion;
    while (!events_.empty() && !(keys_wait && is_typed(events_.front()))) {
        const bool repeats = is_repeat_of(portion, events_.front());
        if (!repeats && taken.hides(events_.front())) break;
        if (!repeats) portion.push_back(std::move(events_.front()));
        events_.pop_front();
    }
    return portion;
}

}  // namespace sphereview

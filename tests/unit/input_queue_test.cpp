// Input in portions: whatever happened, in whatever order, a redraw sees at most one change of each button and key.
#include "viewer/input_queue.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace sphereview {

namespace {

InputEvent random_event(std::mt19937& random) {
    const auto below = [&](unsigned count) { return static_cast<unsigned>(random() % count); };
    const Modifiers modifiers{below(2) == 1, false, false};
    switch (below(5)) {
        case 0: return PointerMoved{static_cast<double>(below(100)), static_cast<double>(below(100))};
        case 1: return ButtonChanged{static_cast<MouseButton>(below(3)), below(2) == 1, modifiers};
        case 2: return WheelTurned{0.0, below(2) == 1 ? 1.0 : -1.0, modifiers};
        case 3: return KeyChanged{below(2) == 1 ? "a" : "backspace", below(2) == 1, false, modifiers};
        default: return CharacterTyped{U'a'};
    }
}

std::string in_words(const InputEvent& event) {
    std::string text = std::to_string(event.index());
    if (const auto* e = std::get_if<PointerMoved>(&event)) text += " " + std::to_string(e->x) + " " + std::to_string(e->y);
    if (const auto* e = std::get_if<ButtonChanged>(&event))
        text += " " + std::to_string(static_cast<int>(e->button)) + (e->pressed ? "d" : "u") + (e->modifiers.control ? "c" : "");
    if (const auto* e = std::get_if<WheelTurned>(&event)) text += " " + std::to_string(e->y);
    if (const auto* e = std::get_if<KeyChanged>(&event))
        text += " " + e->name + (e->pressed ? "d" : "u") + (e->modifiers.control ? "c" : "");
    return text;
}

// Whether widgets that look once a redraw miss something of it.
testing::AssertionResult hides_nothing(const std::vector<InputEvent>& redraw) {
    int buttons = 0;
    bool moved = false;
    bool moved_after = false;
    std::map<std::string, int> keys;
    for (const InputEvent& event : redraw) {
        const auto* button = std::get_if<ButtonChanged>(&event);
        if (button != nullptr) ++buttons;
        if (button != nullptr && !button->pressed && moved)
            return testing::AssertionFailure() << "a drag ends in the redraw of its move";
        if (std::holds_alternative<PointerMoved>(event)) moved = true;
        if (std::holds_alternative<PointerMoved>(event) && buttons > 0) moved_after = true;
        const auto* key = std::get_if<KeyChanged>(&event);
        const bool plain = key != nullptr && key->name.size() == 1 && !key->modifiers.control;
        if (key != nullptr && !plain) ++keys[key->name];
        if (key != nullptr && key->pressed && buttons > 0) return testing::AssertionFailure() << "a key behind a button";
    }
    if (buttons > 1) return testing::AssertionFailure() << buttons << " changes of buttons";
    if (moved_after) return testing::AssertionFailure() << "the pointer moves after a change of a button";
    for (const auto& [name, count] : keys) {
        if (count > 1) return testing::AssertionFailure() << count << " changes of key " << name;
    }
    return testing::AssertionSuccess();
}

}  // namespace

TEST(InputQueue, KeepsEveryEventInItsOrder) {
    for (unsigned trial = 0; trial < 500; ++trial) {
        SCOPED_TRACE("trial " + std::to_string(trial));
        std::mt19937 random(trial);
        InputQueue queue;
        std::vector<std::string> given;
        std::vector<std::string> taken;
        const auto take = [&] {
            const std::vector<InputEvent> redraw = queue.take();
            EXPECT_FALSE(redraw.empty()) << "no progress";
            EXPECT_TRUE(hides_nothing(redraw));
            for (const InputEvent& event : redraw) taken.push_back(in_words(event));
        };
        for (unsigned round = 0; round < 5; ++round) {
            std::vector<InputEvent> events;
            for (auto i = random() % 10; i > 0; --i) events.push_back(random_event(random));
            for (const InputEvent& event : events) given.push_back(in_words(event));
            queue.add(std::move(events));
            if (!queue.empty()) take();
        }
        while (!queue.empty() && !HasFailure()) take();
        ASSERT_EQ(taken, given);
    }
}

TEST(InputQueue, AWordIsTypedInOneFrame) {
    InputQueue queue;
    for (const char letter : std::string("hello")) {
        const std::string key(1, letter);
        queue.add(
            {KeyChanged{key, true, false, {}}, CharacterTyped{static_cast<char32_t>(letter)}, KeyChanged{key, false, false, {}}});
    }
    EXPECT_EQ(queue.take().size(), 15U);
    // But what opens a text box has opened it first, and what ends it comes after the word.
    const Modifiers none;
    queue.add({KeyChanged{"f2", true, false, none}, KeyChanged{"a", true, false, none}, CharacterTyped{U'a'},
               KeyChanged{"enter", true, false, none}});
    EXPECT_EQ(queue.take().size(), 1U);
    EXPECT_EQ(queue.take().size(), 2U);
    EXPECT_EQ(queue.take().size(), 1U);
}

TEST(InputQueue, KeysWaitForABoxThatOpens) {
    InputQueue queue;
    queue.add({PointerMoved{}, KeyChanged{"a", false, false, {}}, KeyChanged{"b", true, false, {}}, CharacterTyped{U'b'},
               PointerMoved{}});
    EXPECT_EQ(queue.take(true).size(), 2U) << "a release is no key that is typed";
    EXPECT_TRUE(queue.take(true).empty());
    EXPECT_EQ(queue.take().size(), 3U);
}

TEST(InputQueue, AHeldKeyDoesNotRunOn) {
    InputQueue queue;
    queue.add({KeyChanged{"page down", true, false, {}}});
    for (int i = 0; i < 90; ++i) queue.add({KeyChanged{"page down", true, true, {}}});
    queue.add({KeyChanged{"page down", false, false, {}}, KeyChanged{"page down", true, false, {}}});
    EXPECT_EQ(queue.take().size(), 1U);
    EXPECT_FALSE(std::get<KeyChanged>(queue.take().at(0)).pressed) << "the release";
    EXPECT_TRUE(std::get<KeyChanged>(queue.take().at(0)).pressed) << "the next press is one of its own";
    EXPECT_TRUE(queue.empty());
}

TEST(InputQueue, SinglePressesOfAKeyThatGoesOnAddUp) {
    const InputQueue::AddsUp pages = [](const KeyChanged& key) { return key.name == "page up"; };
    InputQueue queue;
    for (const char* name : {"page up", "end"}) {
        for (int i = 0; i < 20; ++i) queue.add({KeyChanged{name, true, false, {}}, KeyChanged{name, false, false, {}}});
    }
    EXPECT_EQ(queue.take(false, pages).size(), 41U) << "and the next key's press";
    EXPECT_EQ(queue.take(false, pages).size(), 1U);
    EXPECT_EQ(queue.take(false, pages).size(), 1U);
}

TEST(InputQueue, MovesAndTurnsAddUpInOneFrame) {
    InputQueue queue;
    queue.add({PointerMoved{1, 1}, PointerMoved{2, 2}, WheelTurned{0, 1, {}}, WheelTurned{0, 1, {}}});
    EXPECT_EQ(queue.take().size(), 4U);
    EXPECT_TRUE(queue.empty());
}

}  // namespace sphereview

// The frames of a file in the viewer, without a window; times are given.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "support/environment.hpp"
#include "support/eventually.hpp"
#include "support/temporary_folder.hpp"
#include "viewer/frame_player.hpp"
#include "viewer/perform.hpp"
#include "viewer/scene_file.hpp"
#include "viewer/scene_saving.hpp"

namespace sphereview {

// Two atoms that go along x.
inline std::string moved_frames(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += "2\nProperties=species:S:1:pos:R:3:charge:R:1\nO " + std::to_string(i) + " 0 100 " + std::to_string(i) + "\nH " +
                std::to_string(i) + " 3 100 0\n";
    }
    return text;
}

// Of so many atoms each.
inline std::string sized_frames(const std::vector<int>& sizes) {
    std::string text;
    for (const int size : sizes) {
        text += std::to_string(size) + "\n\n";
        for (int i = 0; i < size; ++i) text += "O " + std::to_string(3 * i) + " 0 100\n";
    }
    return text;
}

struct FramesInViewer : testing::Test {
    FramesInViewer() : state(ViewOptions{}, ViewerSettings{}) { open(moved_frames(5)); }
    ~FramesInViewer() override {
        state.autosave.finish();
        remove_own_recovery();
    }

    void open(const std::string& text, const std::string& name = "a.xyz") {
        path = folder.write(name, text);
        adopt(state, load_scene(path, load_options(state, path, 0)), path);
    }
    void run(CommandId id) { run_command(state, id); }
    const Sphere& sphere(std::size_t number) const { return state.scene().spheres.at(number); }
    Question* question() { return state.dialogs.empty() ? nullptr : std::get_if<Question>(&state.dialogs.back()); }
    void answer(int number) {
        ASSERT_NE(question(), nullptr);
        const Question asked = *question();
        state.dialogs.pop_back();
        asked.answer(number);
    }
    void edit(std::uint32_t number, const std::function<void(Sphere&)>& change, const std::string& name = "Change") {
        Sphere changed = sphere(number);
        change(changed);
        apply(state, {ChangeSpheres{{number}, {changed}}, name});
    }
    // As the loop does, so much time later than before, until a frame is there or the film has stopped.
    FrameNews next(std::chrono::milliseconds later, bool held = false) {
        now += later;
        FrameNews news = FrameNews::none;
        test::eventually([&] {
            const FrameNews one = follow_player(state, now, held);
            if (one == FrameNews::frame || one == FrameNews::stopped) news = one;
            return news != FrameNews::none;
        });
        return news;
    }
    void play() {
        run(CommandId::play);
        now = PlayClock::Time::clock::now();
    }
    // By another program. `asked`: the answer, if there is a question: 0 reloads, 1 keeps what is here.
    void replace_file(const std::string& text, int asked = 0) {
        folder.write("a.xyz", text);
        look_at_file(state);
        EXPECT_TRUE(test::eventually([&] {
            finish_work(state);
            return !state.loading;
        }));
        if (question() != nullptr && question()->id == "reload") answer(asked);
    }
    // In one range for all frames.
    void color_by_charge() { color_by({.property = "charge", .map = ColorMap::grey, .range = ValueRange{0.0, 8.0}}); }
    void color_by(const ColorBy& by) {
        LookPanelState& look = state.side_panel.look;
        const Property& values = *find_property(state.scene().properties, by.property);
        const Coloring coloring = coloring_of(state.scene(), values, by);
        std::vector<Sphere> spheres = state.scene().spheres;
        for (std::size_t i = 0; i < spheres.size(); ++i) spheres[i].color = colors_of(values, coloring)[i];
        note_colors(look, {by, coloring});
        apply(state, {ChangeSpheres{{0, 1}, spheres}, "Colour"});
        ASSERT_NE(shown_coloring(state.document, look), nullptr);
    }
    bool plays() const { return state.player.clock.plays(); }

    test::TemporaryFolder folder;
    test::Variable folder_of_state{"XDG_STATE_HOME", folder.path("state")};  // where changes are kept
    std::string path;
    ViewerState state;
    PlayClock::Time now{};
};

}  // namespace sphereview

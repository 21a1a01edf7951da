// A file of atoms in the viewer, without a window.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "support/temporary_folder.hpp"
#include "viewer/perform.hpp"
#include "viewer/scene_file.hpp"
#include "viewer/scene_saving.hpp"

namespace sphereview {

inline constexpr const char* three_frames = "1\n\nO 0 0 100\n2\n\nO 1 0 100\nH 2 0 100\n2\n\nO 3 0 100\nH 4 0 100\n";

struct DataInViewer : testing::Test {
    DataInViewer() : path(folder.write("a.xyz", three_frames)), state(ViewOptions{}, ViewerSettings{}) {
        adopt(state, load_scene(path), path);
    }

    double x() const { return state.scene().spheres.at(0).center.x; }
    Question* question() { return state.dialogs.empty() ? nullptr : std::get_if<Question>(&state.dialogs.back()); }
    bool is_enabled(CommandId id) const { return info_of(commands_of(state), id).enabled; }
    void add_sphere() { run_command(state, CommandId::add_sphere); }
    void answer(int number) {
        ASSERT_NE(question(), nullptr);
        const auto asked = *question();
        state.dialogs.pop_back();
        asked.answer(number);
    }

    // A file is read beside the loop while edits are still being kept.
    void finish_reading() {
        while (state.loading) {
            state.loading->job.wait_for(std::chrono::milliseconds(100));
            finish_work(state);
        }
    }
    void finish_writing() { sphereview::finish_writing(state, std::chrono::seconds(30)); }
    void open(const std::string& file) {
        open_scene(state, file);
        finish_reading();
    }
    void step_to_next_frame() {
        run_command(state, CommandId::next_frame);
        finish_reading();
    }
    // Whether the file has changed.
    void look() {
        look_at_file(state);
        finish_reading();
    }

    test::TemporaryFolder folder;
    std::string path;
    ViewerState state;
};

}  // namespace sphereview

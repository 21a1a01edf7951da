#include "viewer/box_selection.hpp"

#include <chrono>
#include <cstddef>
#include <optional>
#include <utility>

#include "app/failure.hpp"
#include "cpu/cpu_renderer.hpp"
#include "exact/drawn.hpp"
#include "exact/resolve.hpp"
#include "tiles/build_lists.hpp"
#include "viewer/perform.hpp"
#include "viewer/picture_job.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

// Of the exception being handled.
void report_failure(ViewerState& state) {
    report_error(state, "What is seen in the box cannot be found", describe_current_exception().message);
}

}  // namespace

std::vector<std::uint32_t> spheres_seen(const Scene& scene, const Camera& camera, PictureSize size, const Block& block) {
    const DrawnSpheres drawn = drawn_spheres(scene, camera);
    const CandidateLists lists = build_lists(drawn, camera, size, cpu_tile_costs);
    std::vector<std::int32_t> visible(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
    CpuRenderer(drawn, lists, camera, size).trace(block, visible);
    Resolver(scene, drawn, camera, size, &lists).certify(block, visible);
    std::vector<bool> seen(scene.spheres.size());
    for (const std::int32_t number : visible) {
        if (number >= 0) seen[static_cast<std::size_t>(number)] = true;
    }
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t number = 0; number < seen.size(); ++number) {
        if (seen[number]) numbers.push_back(number);
    }
    return numbers;
}

void select_seen(ViewerState& state, const Block& block, bool toggles) {
    // A redraw can wait so long without anyone noticing.
    constexpr std::chrono::milliseconds patience{10};
    state.box_selection.reset();
    try {
        auto numbers = std::make_shared<std::vector<std::uint32_t>>();
        BackgroundJob job([numbers, block, scene = scene_snapshot(state), camera = state.camera,
                           size = state.picture_size](WorkControl&) { *numbers = spheres_seen(*scene, camera, size, block); });
        state.box_selection.emplace(
            BoxSelection{state.document.revision(), state.selection, toggles, std::move(numbers), std::move(job)});
    } catch (...) {
        return report_failure(state);
    }
    state.box_selection->job.wait_for(patience);
    finish_box_selection(state);
}

bool finish_box_selection(ViewerState& state) {
    if (!state.box_selection || !state.box_selection->job.ended()) return false;
    const BoxSelection done = *std::exchange(state.box_selection, std::nullopt);
    try {
        done.job.rethrow();
    } catch (...) {
        report_failure(state);
        return true;
    }
    const bool same_numbers = !state.document.changes_since(done.revision).order;
    if (!same_numbers || state.selection != done.before) return true;
    Selection selection = state.selection;
    if (done.toggles) {
        selection.toggle_all(*done.numbers);
    } else {
        selection.set(*done.numbers);
    }
    if (selection != state.selection) perform(state, {SelectSpheres{std::move(selection)}});
    return true;
}

}  // namespace sphereview

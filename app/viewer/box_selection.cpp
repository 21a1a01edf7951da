#include "viewer/box_selection.hpp"

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
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
    const auto fail = [&state](const std::string& why) { report_error(state, "What is seen in the box cannot be found", why); };
    state.selecting.reset();
    try {
        const auto numbers = std::make_shared<std::vector<std::uint32_t>>();
        BackgroundJob job([numbers, block, scene = scene_snapshot(state), camera = state.camera,
                           size = state.picture_size](WorkControl&) { *numbers = spheres_seen(*scene, camera, size, block); });
        const auto done = [&state, numbers, toggles, before = state.selection, revision = state.document.revision()] {
            if (state.document.changes_since(revision).order || state.selection != before) return;
            Selection selection = before;
            if (toggles) {
                selection.toggle_all(*numbers);
            } else {
                selection.set(*numbers);
            }
            if (selection != before) perform(state, {SelectSpheres{std::move(selection)}});
        };
        state.selecting.emplace(Work{.path = "", .job = std::move(job), .done = done, .fail = fail});
    } catch (...) {
        return fail(describe_current_exception().message);
    }
    state.selecting->job.wait_for(patience);
    finish(state.selecting);
}

}  // namespace sphereview

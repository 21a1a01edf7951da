// The side panel in a harness.
#pragma once

#include <gtest/gtest.h>

#include "panels/side_panel.hpp"
#include "support/panel_harness.hpp"

namespace sphereview {

// A base, so that it is there when PanelHarness draws for the first time.
struct HeldSidePanel {
    SidePanelState held;
};

class SidePanelHarness : private HeldSidePanel, public PanelHarness {
public:
    explicit SidePanelHarness(Scene scene, float height = 700.0F)
        : PanelHarness(in_window([this](const PanelContext& context) { draw_side_panel(context, state()); }, 340.0F, height),
                       std::move(scene), 1400.0F, 1200.0F) {
        take_actions();
    }

    SidePanelState& state() { return held; }

    // Selects as a click does, without one.
    void select(std::uint32_t number) {
        selection.set_only(number);
        frames(2);
    }
    const Sphere& sphere(std::uint32_t number) const { return document.scene().spheres.at(number); }

    // How many rows were drawn.
    std::size_t rows() const {
        std::size_t count = 0;
        for (const auto& [name, rectangle] : rectangles) count += name.starts_with("row ") && name.ends_with(" eye") ? 1U : 0U;
        return count;
    }
};

// Spheres 0, 1, 2, ... in a line, with values that no slider gives.
inline Scene line_of_spheres(std::size_t count) {
    Scene scene;
    scene.spheres.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto x = static_cast<double>(i);
        scene.spheres[i] = {{x / 3.0, x / 7.0 - 5.0, 200.0 + x / 11.0}, 1.0 + x / 13.0, {10, 20, 30}};
    }
    return scene;
}

}  // namespace sphereview

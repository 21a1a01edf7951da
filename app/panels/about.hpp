// Help > About: the version, what renders, and the licences of the parts.
#pragma once

#include <string>
#include <vector>

#include "panels/panel_context.hpp"

namespace sphereview {

struct About {
    bool shown = false;
    std::vector<std::string> lines{};  // of the licences, once they are shown
};

// Draws a window with a close button. `licenses`, which may be null, is called once, when its long text is first shown. `renderer`:
// as the status bar names it. Widgets: "about", "about copy".
void draw_about(const PanelContext& context, About& about, const std::string& name_and_version, std::string (*licenses)(),
                const std::string& renderer);

}  // namespace sphereview

// How all panels look.
#pragma once

namespace sphereview {

// Gives the current ImGui context our dark theme. Sizes are times `scale`; may be called again for another.
void apply_style(float scale);

}  // namespace sphereview

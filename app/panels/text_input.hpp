// What Dear ImGui's text and key input lacks, the same for 1.86 and later releases.
#pragma once

#include <imgui.h>

#include <string>

namespace sphereview {

// ImGui::InputTextWithHint for a string of any length.
bool input_text(const char* label, const char* hint, std::string& text, ImGuiInputTextFlags flags = 0);

// Whether a key, as ImGui calls it (ImGuiKey_UpArrow), went down or repeats.
bool key_pressed(ImGuiKey key);

}  // namespace sphereview

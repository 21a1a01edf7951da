// GL programs made from shader files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gpu/gl_object.hpp"
#include "gpu/shader_source.hpp"

namespace sphereview {

// Compiles and links fullscreen.vert with `fragment_file`, binds its uniform blocks, and checks their layout against
// gpu/layouts.hpp. Throws RenderError with the log, which names the file and line as written.
Program make_program(std::string_view fragment_file, const std::vector<std::string>& defines, const ShaderFiles& files = {});

}  // namespace sphereview

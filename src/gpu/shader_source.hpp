// GLSL as written, with `#include "FILE"`, which GL does not have.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sphereview {

// The shaders in the program, by file name. Made from shaders/ by the build.
const std::map<std::string, std::string_view, std::less<>>& embedded_shaders();

// A shader ready for GL, and the files that it came from: source string number i of a log is files[i].
struct ShaderSource {
    std::string text;
    std::vector<std::string> files;
};

// The shader `file` with its includes, each at most once, and `defines` ("NAME VALUE") after its #version.
// Throws RenderError when a file is missing.
ShaderSource assemble_shader(std::string_view file, const std::vector<std::string>& defines);

// A compiler's log with its "0:12" or "0(12)" turned into "trace.frag:12".
std::string name_files_in_log(std::string_view log, const std::vector<std::string>& files);

}  // namespace sphereview

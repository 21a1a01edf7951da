// Makes GL programs from shader files: GLSL with `#include "FILE"`, which GL lacks.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/gl_object.hpp"

namespace sphereview {

// The shaders in the program, by file name; the build makes them from shaders/.
const std::map<std::string, std::string_view, std::less<>>& embedded_shaders();

// The shaders to compile, by file name: the files of a folder that a person edits, and the program's own for all that the folder
// lacks, so that a folder with one changed file is enough.
class ShaderFiles {
public:
    ShaderFiles() = default;
    // Reads all files of the folder that may be shaders (.vert, .frag, .glsl). Throws InputError.
    explicit ShaderFiles(const std::string& folder);

    // Throws RenderError when there is no such file, or only one that is not regular, such as a FIFO. Valid as long as this object.
    std::string_view text(std::string_view file) const;

private:
    std::map<std::string, std::optional<std::string>, std::less<>> read_;  // nothing for a file that is not regular
};

// A shader ready for GL, and its files: source string number i in a log is files[i].
struct ShaderSource {
    std::string text;
    std::vector<std::string> files;
};

// The shader `file` with its includes, each at most once, and `defines` ("NAME VALUE") after its #version.
// Throws RenderError when a file is missing.
ShaderSource assemble_shader(std::string_view file, const std::vector<std::string>& defines, const ShaderFiles& files = {});

// A compiler's log with its "0:12" or "0(12)" turned into "trace.frag:12".
std::string name_files_in_log(std::string_view log, const std::vector<std::string>& files);

// Compiles and links fullscreen.vert with `fragment_file`, binds its uniform blocks, and checks their layout against
// gpu/layouts.hpp. Throws RenderError with the log, which names the file and line as written.
Program make_program(std::string_view fragment_file, const std::vector<std::string>& defines, const ShaderFiles& files = {});

}  // namespace sphereview

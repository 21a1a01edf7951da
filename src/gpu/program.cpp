#include "gpu/program.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <system_error>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/path.hpp"
#include "base/text.hpp"
#include "gpu/layouts.hpp"

namespace sphereview {

namespace {

void append_file(const std::string& file, const std::vector<std::string>& defines, const ShaderFiles& files, ShaderSource& source) {
    if (std::find(source.files.begin(), source.files.end(), file) != source.files.end()) return;
    std::string_view rest = without_byte_order_mark(files.text(file));

    const std::string number = std::to_string(source.files.size());
    source.files.push_back(file);
    if (number != "0") source.text += "#line 1 " + number + "\n";  // nothing may stand before the first file's #version

    constexpr std::string_view include = "#include \"";
    std::size_t line_number = 0;
    while (!rest.empty()) {
        const std::string_view line = take_line(rest);
        ++line_number;
        const auto resume = [&] { source.text += "#line " + std::to_string(line_number + 1) + " " + number + "\n"; };
        if (line.starts_with(include)) {
            const std::string_view name = line.substr(include.size(), line.rfind('"') - include.size());
            append_file(std::string(name), {}, files, source);
            resume();
        } else if (line.starts_with("#version")) {
            source.text.append(line) += '\n';
            for (const std::string& define : defines) source.text += "#define " + define + "\n";
            resume();
        } else {
            source.text.append(line) += '\n';
        }
    }
}

// A line of a log, with the place that it begins with named, perhaps behind a word. Mesa: "0:12(5): error"; NVIDIA:
// "0(12) : error"; Apple, AMD: "ERROR: 0:12:".
std::string name_file_in_line(std::string_view line, const std::vector<std::string>& files) {
    constexpr std::string_view behind_word = ": ";
    const std::size_t word = line.find(behind_word);
    const bool has_word = word != std::string_view::npos && line.find_first_of("0123456789") > word;
    const std::string_view place = line.substr(has_word ? word + behind_word.size() : 0);
    const char* const end = line.data() + line.size();
    std::size_t file = 0;
    std::size_t number = 0;
    const auto [separator, no_file] = std::from_chars(place.data(), end, file);
    if (no_file != std::errc{} || separator == end || (*separator != ':' && *separator != '(') || file >= files.size())
        return std::string(line);
    auto [rest, no_number] = std::from_chars(separator + 1, end, number);
    if (no_number != std::errc{}) return std::string(line);
    if (*separator == '(' && rest != end && *rest == ')') ++rest;
    return std::string(line.data(), place.data()) + files[file] + ":" + std::to_string(number) + std::string(rest, end);
}

Shader compile(GLenum stage, std::string_view file, const std::vector<std::string>& defines, const ShaderFiles& files) {
    const ShaderSource source = assemble_shader(file, defines, files);
    Shader shader(glCreateShader(stage));
    const char* text = source.text.c_str();
    glShaderSource(shader.name(), 1, &text, nullptr);
    glCompileShader(shader.name());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return shader;
    GLint length = 0;
    glGetShaderiv(shader.name(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length) + 1, '\0');
    glGetShaderInfoLog(shader.name(), length + 1, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    throw RenderError("the shader " + std::string(file) + " does not compile:\n" + name_files_in_log(log, source.files));
}

void bind_block(GLuint program, const char* name, BlockBinding binding) {
    const GLuint index = glGetUniformBlockIndex(program, name);
    if (index != GL_INVALID_INDEX) glUniformBlockBinding(program, index, static_cast<GLuint>(binding));
}

// std140 leaves no choice, but a member renamed or moved in one twin alone would go unnoticed. A shader that a person edits may do
// without the block.
void check_draw_layout(GLuint program, std::string_view file) {
    if (glGetUniformBlockIndex(program, "Draw") == GL_INVALID_INDEX) return;
    for (const BlockMember& member : draw_members) {
        GLuint index = GL_INVALID_INDEX;
        glGetUniformIndices(program, 1, &member.name, &index);
        GLint offset = -1;
        if (index != GL_INVALID_INDEX) glGetActiveUniformsiv(program, 1, &index, GL_UNIFORM_OFFSET, &offset);
        if (offset != static_cast<GLint>(member.offset)) {
            throw RenderError(std::string(file) + ": GL has Draw." + member.name + " at byte " + std::to_string(offset) +
                              ", the program at " + std::to_string(member.offset));
        }
    }
}

}  // namespace

ShaderFiles::ShaderFiles(const std::string& folder) {
    namespace fs = std::filesystem;
    std::error_code error;
    for (fs::directory_iterator entry(path_from(folder), error), end; !error && entry != end; entry.increment(error)) {
        const std::string extension = text_from(entry->path().extension());
        const std::string name = text_from(entry->path().filename());
        if (name.starts_with('.')) continue;  // an editor's
        if (extension != ".vert" && extension != ".frag" && extension != ".glsl") continue;
        std::optional<std::string>& text = read_[name];
        // A FIFO would be waited for.
        if (std::error_code ignored; entry->is_regular_file(ignored)) text = InputFile(text_from(entry->path())).bytes();
    }
    if (error) throw InputError(folder + ": cannot read the shaders in it: " + error.message());
    if (read_.empty()) throw InputError(folder + ": no shaders in it, expected files like trace.frag");
}

std::string_view ShaderFiles::text(std::string_view file) const {
    if (const auto found = read_.find(file); found != read_.end()) {
        if (!found->second) throw RenderError("the shader file '" + std::string(file) + "' is no regular file");
        return *found->second;
    }
    const auto& embedded = embedded_shaders();
    const auto found = embedded.find(file);
    if (found == embedded.end()) throw RenderError("the shader file '" + std::string(file) + "' is missing");
    return found->second;
}

ShaderSource assemble_shader(std::string_view file, const std::vector<std::string>& defines, const ShaderFiles& files) {
    ShaderSource source;
    append_file(std::string(file), defines, files, source);
    return source;
}

std::string name_files_in_log(std::string_view log, const std::vector<std::string>& files) {
    std::string named;
    while (!log.empty()) named += name_file_in_line(take_line(log), files) + "\n";
    return named;
}

Program make_program(std::string_view fragment_file, const std::vector<std::string>& defines, const ShaderFiles& files) {
    const Shader vertex = compile(GL_VERTEX_SHADER, "fullscreen.vert", defines, files);
    const Shader fragment = compile(GL_FRAGMENT_SHADER, fragment_file, defines, files);
    Program program(glCreateProgram());
    glAttachShader(program.name(), vertex.name());
    glAttachShader(program.name(), fragment.name());
    glLinkProgram(program.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        throw RenderError("the shader " + std::string(fragment_file) + " does not link:\n" + log);
    }
    bind_block(program.name(), "Draw", BlockBinding::draw);
    bind_block(program.name(), "Spheres", BlockBinding::spheres);
    bind_block(program.name(), "Colors", BlockBinding::colors);
    check_draw_layout(program.name(), fragment_file);
    glUseProgram(program.name());
    for (std::size_t unit = 0; unit < sampler_names.size(); ++unit) {
        const GLint location = glGetUniformLocation(program.name(), sampler_names[unit]);
        if (location >= 0) glUniform1i(location, static_cast<GLint>(unit));
    }
    return program;
}

}  // namespace sphereview

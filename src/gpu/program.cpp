#include "gpu/program.hpp"

#include "base/error.hpp"
#include "gpu/layouts.hpp"

namespace sphereview {

namespace {

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
            throw RenderError(std::string(file) + ": GL has Frame." + member.name + " at byte " + std::to_string(offset) +
                              ", the program at " + std::to_string(member.offset));
        }
    }
}

}  // namespace

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

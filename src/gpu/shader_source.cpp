#include "gpu/shader_source.hpp"

#include <algorithm>
#include <charconv>

#include "base/error.hpp"

namespace sphereview {

namespace {

void append_file(const std::string& file, const std::vector<std::string>& defines, ShaderSource& source) {
    if (std::find(source.files.begin(), source.files.end(), file) != source.files.end()) return;
    const auto& shaders = embedded_shaders();
    const auto found = shaders.find(file);
    if (found == shaders.end()) throw RenderError("the shader file '" + file + "' is missing");

    const std::string number = std::to_string(source.files.size());
    source.files.push_back(file);
    if (number != "0") source.text += "#line 1 " + number + "\n";  // nothing may stand before the first file's #version

    constexpr std::string_view include = "#include \"";
    std::size_t line_number = 0;
    std::string_view rest = found->second;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = rest.substr(0, end);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        ++line_number;
        const auto resume = [&] { source.text += "#line " + std::to_string(line_number + 1) + " " + number + "\n"; };
        if (line.starts_with(include)) {
            const std::string_view name = line.substr(include.size(), line.rfind('"') - include.size());
            append_file(std::string(name), {}, source);
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

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_word(char c) { return is_digit(c) || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '.'; }

std::size_t skip_digits(std::string_view text, std::size_t at) {
    while (at < text.size() && is_digit(text[at])) ++at;
    return at;
}

// The first place in a line of a log, named. Mesa: "0:12(5): error"; NVIDIA: "0(12) : error"; Apple, AMD: "ERROR: 0:12:".
std::string name_file_in_line(std::string_view line, const std::vector<std::string>& files) {
    for (std::size_t begin = 0; begin < line.size(); ++begin) {
        if (!is_digit(line[begin]) || (begin > 0 && is_word(line[begin - 1]))) continue;
        const std::size_t separator = skip_digits(line, begin);
        if (separator == line.size() || (line[separator] != ':' && line[separator] != '(')) continue;
        const std::size_t end = skip_digits(line, separator + 1);
        if (end == separator + 1) continue;

        std::size_t number = files.size();
        std::from_chars(line.data() + begin, line.data() + separator, number);
        if (number >= files.size()) break;
        std::string_view rest = line.substr(end);
        if (line[separator] == '(' && rest.starts_with(')')) rest.remove_prefix(1);
        return std::string(line.substr(0, begin)) + files[number] + ":" +
               std::string(line.substr(separator + 1, end - separator - 1)) + std::string(rest);
    }
    return std::string(line);
}

}  // namespace

ShaderSource assemble_shader(std::string_view file, const std::vector<std::string>& defines) {
    ShaderSource source;
    append_file(std::string(file), defines, source);
    return source;
}

std::string name_files_in_log(std::string_view log, const std::vector<std::string>& files) {
    std::string named;
    while (!log.empty()) {
        const std::size_t end = std::min(log.find('\n'), log.size());
        named += name_file_in_line(log.substr(0, end), files) + "\n";
        log.remove_prefix(std::min(end + 1, log.size()));
    }
    return named;
}

}  // namespace sphereview

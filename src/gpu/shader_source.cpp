#include "gpu/shader_source.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <system_error>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/text.hpp"

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
        const std::size_t end = rest.find('\n');
        const std::string_view line = rest.substr(0, end);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
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

ShaderFiles::ShaderFiles(const std::string& folder) {
    namespace fs = std::filesystem;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string extension = entry->path().extension().string();
        const std::string name = entry->path().filename().string();
        if (name.starts_with('.')) continue;  // an editor's
        if (extension != ".vert" && extension != ".frag" && extension != ".glsl") continue;
        read_[name] = InputFile(entry->path().string()).bytes();
    }
    if (error) throw InputError(folder + ": cannot read the shaders in it: " + error.message());
    if (read_.empty()) throw InputError(folder + ": no shaders in it, expected files like trace.frag");
}

std::string_view ShaderFiles::text(std::string_view file) const {
    if (const auto found = read_.find(file); found != read_.end()) return found->second;
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
    while (!log.empty()) {
        const std::size_t end = std::min(log.find('\n'), log.size());
        named += name_file_in_line(log.substr(0, end), files) + "\n";
        log.remove_prefix(std::min(end + 1, log.size()));
    }
    return named;
}

}  // namespace sphereview

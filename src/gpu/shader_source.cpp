#include "gpu/shader_source.hpp"

#include <algorithm>
#include <regex>

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

}  // namespace

ShaderSource assemble_shader(std::string_view file, const std::vector<std::string>& defines) {
    ShaderSource source;
    append_file(std::string(file), defines, source);
    return source;
}

std::string name_files_in_log(std::string_view log, const std::vector<std::string>& files) {
    // Mesa: "0:12(5): error"; NVIDIA: "0(12) : error"; Apple, AMD: "ERROR: 0:12:".
    static const std::regex place(R"((^|[^0-9A-Za-z_.])(\d+)[:(](\d+)\)?)");
    std::string named;
    std::string text(log);
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        begin = end + 1;
        std::smatch match;
        const bool found = std::regex_search(line, match, place) && match[2].length() < 4 &&
                           std::stoul(match[2].str()) < files.size();
        if (found) {
            named += match.prefix().str() + match[1].str() + files[std::stoul(match[2].str())] + ":" + match[3].str() +
                     match.suffix().str() + "\n";
        } else {
            named += line + "\n";
        }
    }
    return named;
}

}  // namespace sphereview

#include "image/whole_png.hpp"

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

#include "base/path.hpp"
#include "base/standard_streams.hpp"

namespace sphereview {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view png_begin = "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR"sv;
constexpr std::string_view png_end = "\0\0\0\0IEND\xae\x42\x60\x82"sv;

}  // namespace

bool is_whole_png(const std::string& path, int width, int height) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path_from(path), ignored)) return false;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(open_file(path, "rb"), &std::fclose);
    if (!file) return false;
    std::string wanted(png_begin);
    for (const int side : {width, height}) {
        for (const int bits : {24, 16, 8, 0}) wanted += static_cast<char>(side >> bits & 0xFF);
    }
    std::string begin(wanted.size(), '\0');
    if (std::fread(begin.data(), 1, begin.size(), file.get()) != begin.size() || begin != wanted) return false;
    std::array<char, png_end.size()> end{};
    if (std::fseek(file.get(), -static_cast<long>(end.size()), SEEK_END) != 0) return false;
    return std::fread(end.data(), 1, end.size(), file.get()) == end.size() && std::string_view(end.data(), end.size()) == png_end;
}

}  // namespace sphereview

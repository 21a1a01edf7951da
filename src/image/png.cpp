#include "image/png.hpp"

#include <stb_image_write.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <filesystem>
#include <new>
#include <system_error>

#include "base/error.hpp"
#include "base/output_file.hpp"
#include "base/path.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

// stb's callback: appends to the std::string behind `context`.
void append(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

namespace fs = std::filesystem;

// With its dot; "" where there is none.
std::string ending_of(const fs::path& path) {
    constexpr std::size_t longest = std::string_view(".12345").size();
    const std::string ending = text_from(path.extension());
    const auto is_part = [](unsigned char c) { return std::isalnum(c) != 0; };
    const bool is_ending = ending.size() > 1 && ending.size() <= longest &&
                           std::isalpha(static_cast<unsigned char>(ending[1])) != 0 &&
                           std::all_of(ending.begin() + 1, ending.end(), is_part);
    return is_ending ? ending : "";
}

// Whether bytes go to `path` under no name of a file: /dev/stdout may lead to a regular one.
bool is_no_file_name(const std::string& path) {
    if (path == "-" || path.starts_with("/dev/") || path.starts_with("/proc/")) return true;
    if (is_device_name(path_from(path))) return true;
    std::error_code error;
    const fs::file_status status = fs::status(path_from(path), error);
    return (fs::exists(status) && !fs::is_regular_file(status)) || !path_from(path).has_filename();
}

}  // namespace

std::string png_name(const std::string& path) {
    if (is_no_file_name(path)) return path;
    const std::string ending = ending_of(path_from(path));
    if (path.ends_with('.')) throw InputError(path + ": found no ending behind the last '.', expected .png or a name without one");
    if (ending.empty()) return path + ".png";
    if (lower_case(ending) == ".png") return path;
    throw InputError(path + ": found the ending " + ending + ", expected .png: pictures are written as PNG alone");
}

std::string encode_png(const Image& image) {
    assert(static_cast<std::int64_t>(image.width()) * image.height() <= most_pixels);
    // No filter: rows of flat colours compress best as they are, and trying all five costs more than compressing.
    stbi_write_force_png_filter = 0;
    std::string bytes;
    const int done =
        stbi_write_png_to_func(append, &bytes, image.width(), image.height(), image.channels(), image.bytes().data(), 0);
    if (done == 0) throw std::bad_alloc();
    return bytes;
}

}  // namespace sphereview

// Reading PNGs with libpng. It leaves by longjmp where something is wrong, so no function between its calls and setjmp may own
// anything.
#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/text.hpp"
#include "image/png.hpp"

namespace sphereview {

struct PngReader::Reading {
    std::string name;
    Source source;
    png_structp png = nullptr;
    png_infop info = nullptr;
    int width = 0;
    int height = 0;
    int channels = 0;

    // Why libpng left.
    std::array<char, 200> said{};
    std::exception_ptr fault{};  // of `source`
    bool memory_ran_out = false;

    Reading(std::string called, Source from);
    ~Reading() { png_destroy_read_struct(&png, &info, nullptr); }
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;

    // Calls what calls libpng.
    template <typename Call>
    void guarded(const Call& call) {
        if (setjmp(png_jmpbuf(png)) == 0) return call();
        if (fault) std::rethrow_exception(fault);
        if (memory_ran_out) throw std::bad_alloc();
        fail(said.data());
    }

    [[noreturn]] void fail(const std::string& why) const { throw InputError(name + ": not a usable PNG: " + why); }

    // Fills `to`; false when the file ends before, or the source fails.
    bool take_bytes(char* to, std::size_t count) {
        try {
            while (count > 0) {
                const std::size_t taken = source(to, count);
                if (taken == 0) return false;
                to += taken;
                count -= taken;
            }
            return true;
        } catch (...) {
            fault = std::current_exception();
            return false;
        }
    }

    // libpng's callbacks.

    [[noreturn]] static void on_error(png_structp png, png_const_charp message) {
        auto& said = static_cast<Reading*>(png_get_error_ptr(png))->said;
        std::snprintf(said.data(), said.size(), "%s", message);
        png_longjmp(png, 1);
    }

    static void on_warning(png_structp /*png*/, png_const_charp /*message*/) {}

    static void on_read(png_structp png, png_bytep to, png_size_t count) {
        auto* reading = static_cast<Reading*>(png_get_io_ptr(png));
        if (!reading->take_bytes(reinterpret_cast<char*>(to), count)) png_error(png, "it is cut off");
    }

    static png_voidp allocate(png_structp png, png_alloc_size_t size) {
        void* memory = std::malloc(size);
        if (memory == nullptr) static_cast<Reading*>(png_get_mem_ptr(png))->memory_ran_out = true;
        return memory;
    }

    static void release(png_structp /*png*/, png_voidp memory) { std::free(memory); }
};

PngReader::Reading::Reading(std::string called, Source from) : name(std::move(called)), source(std::move(from)) {
    png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, this, on_error, on_warning, this, allocate, release);
    if (png != nullptr) info = png_create_info_struct(png);
    if (info == nullptr) {
        png_destroy_read_struct(&png, nullptr, nullptr);
        throw std::bad_alloc();
    }
}

PngReader::PngReader(std::string name, Source source) : reading_(std::make_unique<Reading>(std::move(name), std::move(source))) {
    Reading& r = *reading_;
    r.guarded([&r] {
        png_set_read_fn(r.png, &r, Reading::on_read);
        // Texts and colour profiles are not for us, but their sums count as all do. What is odd about the rest is a fault.
        png_set_keep_unknown_chunks(r.png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
        png_set_crc_action(r.png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
        png_set_benign_errors(r.png, 0);
        png_set_user_limits(r.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        png_set_chunk_malloc_max(r.png, 0);
        png_read_info(r.png, r.info);
    });
    if (png_get_bit_depth(r.png, r.info) == 16) r.fail("its channels have 16 bits, expected 8");
    r.width = static_cast<int>(png_get_image_width(r.png, r.info));
    r.height = static_cast<int>(png_get_image_height(r.png, r.info));
    const bool has_alpha = (png_get_color_type(r.png, r.info) & PNG_COLOR_MASK_ALPHA) != 0;
    r.channels = has_alpha || png_get_valid(r.png, r.info, PNG_INFO_tRNS) != 0 ? 4 : 3;
}

PngReader::PngReader(PngReader&&) noexcept = default;
PngReader::~PngReader() = default;

const std::string& PngReader::name() const { return reading_->name; }
int PngReader::width() const { return reading_->width; }
int PngReader::height() const { return reading_->height; }
int PngReader::channels() const { return reading_->channels; }

void PngReader::read(const std::function<void(const PngRow&)>& take) {
    Reading& r = *reading_;
    const auto width = static_cast<png_uint_32>(r.width);
    const auto height = static_cast<png_uint_32>(r.height);
    const bool interlaced = png_get_interlace_type(r.png, r.info) != PNG_INTERLACE_NONE;
    r.guarded([&r] {
        png_set_expand(r.png);
        png_set_gray_to_rgb(r.png);
        png_read_update_info(r.png, r.info);
    });
    std::vector<std::uint8_t> row(png_get_rowbytes(r.png, r.info));
    const auto read_row = [&r, &row] { png_read_row(r.png, row.data(), nullptr); };
    for (unsigned pass = 0; pass < (interlaced ? PNG_INTERLACE_ADAM7_PASSES : 1U); ++pass) {
        const std::size_t columns = interlaced ? PNG_PASS_COLS(width, pass) : width;
        const int rows = static_cast<int>(interlaced ? PNG_PASS_ROWS(height, pass) : height);
        if (columns == 0) continue;
        const int first_x = interlaced ? static_cast<int>(PNG_PASS_START_COL(pass)) : 0;
        const int step = interlaced ? static_cast<int>(PNG_PASS_COL_OFFSET(pass)) : 1;
        for (int y = 0; y < rows; ++y) {
            r.guarded(read_row);
            const int place = interlaced ? static_cast<int>(PNG_ROW_FROM_PASS_ROW(y, pass)) : y;
            take({place, first_x, step, {row.data(), columns * static_cast<std::size_t>(r.channels)}});
        }
    }
    r.guarded([&r] { png_read_end(r.png, nullptr); });
}

PngReader open_png(const std::string& path) {
    constexpr std::size_t window = std::size_t{1} << 18;
    const auto stream = std::make_shared<InputStream>(path, Content::binary);
    return {stream->name(), [stream](char* to, std::size_t most) {
                if (stream->bytes().empty()) stream->fill(window);
                const std::string_view bytes = stream->bytes().substr(0, most);
                std::memcpy(to, bytes.data(), bytes.size());
                stream->drop_first(bytes.size());
                return bytes.size();
            }};
}

Image decode_png(std::string_view bytes, const std::string& name) {
    PngReader reader(name, [&bytes](char* to, std::size_t most) {
        const std::size_t count = std::min(most, bytes.size());
        std::copy_n(bytes.data(), count, to);
        bytes.remove_prefix(count);
        return count;
    });
    const std::int64_t pixels = static_cast<std::int64_t>(reader.width()) * reader.height();
    if (pixels > most_pixels) {
        throw InputError(name + ": found " + in_groups(static_cast<std::uint64_t>(pixels)) + " pixels, expected at most " +
                         in_groups(most_pixels));
    }
    Image image(reader.width(), reader.height(), reader.channels());
    reader.read([&image](const PngRow& row) {
        const auto channels = static_cast<std::size_t>(image.channels());
        for (std::size_t i = 0; i < row.bytes.size(); i += channels) {
            const int x = row.first_x + row.step * static_cast<int>(i / channels);
            std::memcpy(image.at(x, row.y), &row.bytes[i], channels);
        }
    });
    return image;
}

}  // namespace sphereview

// Unpacks gzip (RFC 1952) as it comes in, by zlib's inflate(): its gzread() opens files alone, and here the beginning was read
// already to tell what the file is, perhaps from a pipe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "base/gzip_places.hpp"

struct z_stream_s;

namespace sphereview {

// What every gzip file begins with.
inline constexpr std::string_view gzip_magic = "\x1f\x8b";

// `name` without the .gz at its end, in any letter case.
std::string_view without_gzip_ending(std::string_view name);

// How far a file may expand: beyond `small`, not to more than `ratio` times its packed size; and never beyond `most` bytes.
// Numbers expand 2 to 20 times; bombs come near deflate's limit of 1032. Nobody knows the size of a packed text before it ends.
struct ExpansionBounds {
    std::uint64_t small = std::uint64_t{1} << 26;
    std::uint64_t ratio = 250;
    std::uint64_t most = std::uint64_t{1} << 36;
};

// A file of one or several gzip members, which count as one text. Zeros behind the last one are padding.
class Gunzip {
public:
    // Reads up to so many bytes of the packed file; 0 only at its end.
    using Source = std::function<std::size_t(char* to, std::size_t most)>;

    // `begin`: what was read of the file already. `name`: how messages call it.
    Gunzip(std::string name, std::string_view begin, Source source, ExpansionBounds bounds = {});

    // Goes on from such a place, without the sums of what its member has before it. `source` begins there, or where the place has
    // bits, a byte before.
    Gunzip(std::string name, const GzipPlace& place, Source source, ExpansionBounds bounds = {});

    // From now on adds places to these, while that is not null.
    void remember_places(std::shared_ptr<GzipPlaces> places) { places_ = std::move(places); }

    // Unpacks up to `most` bytes; 0 only at the end. Throws InputError "NAME: cannot be unpacked: ..." when the data are damaged,
    // end too early, or expand beyond the bounds.
    std::size_t read(char* to, std::size_t most);

    // Bytes of the packed file before what will be read next of it.
    std::uint64_t packed_size() const { return packed_size_; }

private:
    struct End {
        void operator()(z_stream_s* stream) const;
    };

    [[noreturn]] void fail(const std::string& why) const;
    bool refill();
    bool begin_next_member();
    void pass_end_of_member();
    void remember_place(std::uint64_t unpacked);
    void check_bounds() const;

    std::string name_;
    Source source_;
    ExpansionBounds bounds_;
    std::unique_ptr<char[]> packed_;
    std::unique_ptr<z_stream_s, End> stream_;
    std::uint64_t packed_size_ = 0;  // of what was read
    std::uint64_t unpacked_size_ = 0;
    bool in_member_ = true;
    bool is_bare_ = false;  // the member was begun in its middle: zlib does not look for its head and its end
    std::shared_ptr<GzipPlaces> places_{};
};

}  // namespace sphereview

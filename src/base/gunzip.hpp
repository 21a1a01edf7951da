// Unpacks gzip (RFC 1952) as it comes in, by zlib's inflate(). gzread() would not do: it opens files, but the file's beginning was
// read already to tell its format, perhaps from a pipe.
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

// The beginning of every gzip file.
inline constexpr std::string_view gzip_magic = "\x1f\x8b";

// `name` without the .gz at its end, in any letter case.
std::string_view without_gzip_ending(std::string_view name);

// Bounds on a file's expansion, since the size of a packed text is unknown before its end: beyond `small` bytes at most `ratio`
// times the packed size, and never beyond `most` bytes. Numbers expand 2 to 20 times; bombs come near deflate's limit of 1032.
struct ExpansionBounds {
    std::uint64_t small = std::uint64_t{1} << 26;
    std::uint64_t ratio = 250;
    std::uint64_t most = std::uint64_t{1} << 36;
};

// A file of one or several gzip members, which form one text. Zeros behind the last one are padding.
class Gunzip {
public:
    // Reads up to so many bytes of the packed file; 0 only at its end.
    using Source = std::function<std::size_t(char* to, std::size_t most)>;

    // `begin`: the bytes that were read already. `name`: the file's in messages.
    Gunzip(std::string name, std::string_view begin, Source source, ExpansionBounds bounds = {});

    // Goes on from `place`, without checking the sum of the member there. `source` begins at the place, or, if the place has bits,
    // a byte before.
    Gunzip(std::string name, const GzipPlace& place, Source source, ExpansionBounds bounds = {});

    // From now on adds places to `places`, unless null.
    void remember_places(std::shared_ptr<GzipPlaces> places) { places_ = std::move(places); }

    // Unpacks up to `most` bytes; 0 only at the end. Throws InputError "NAME: cannot be unpacked: ..." when the data are damaged,
    // end too early, or expand beyond the bounds.
    std::size_t read(char* to, std::size_t most);

    // Bytes of the packed file that are consumed.
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
    bool is_bare_ = false;  // begun inside a member: zlib ignores its head and end
    std::shared_ptr<GzipPlaces> places_{};
};

}  // namespace sphereview

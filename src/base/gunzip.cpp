#include "base/gunzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <new>

#include "base/error.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

constexpr std::size_t packed_capacity = std::size_t{1} << 17;
constexpr std::size_t most_padding = std::size_t{1} << 20;  // far more than tape drives and archives pad with
constexpr int gzip_windows = 15 + 16;                       // zlib: any window, gzip only
constexpr int bare_windows = -15;                           // zlib: any window, deflate alone
constexpr std::size_t member_end_size = 8;                  // its sum and its size

}  // namespace

std::string_view without_gzip_ending(std::string_view name) {
    constexpr std::string_view ending = ".gz";
    if (has_ending(name, ending)) name.remove_suffix(ending.size());
    return name;
}

void Gunzip::End::operator()(z_stream_s* stream) const {
    inflateEnd(stream);
    delete stream;
}

Gunzip::Gunzip(std::string name, std::string_view begin, Source source, ExpansionBounds bounds)
    : name_(std::move(name)),
      source_(std::move(source)),
      bounds_(bounds),
      packed_(std::make_unique_for_overwrite<char[]>(packed_capacity)),
      stream_(new z_stream_s{}) {
    if (inflateInit2(stream_.get(), gzip_windows) != Z_OK) throw std::bad_alloc();
    assert(begin.size() <= packed_capacity);
    std::copy_n(begin.data(), begin.size(), packed_.get());
    stream_->next_in = reinterpret_cast<Bytef*>(packed_.get());
    stream_->avail_in = static_cast<uInt>(begin.size());
    packed_size_ = begin.size();
}

Gunzip::Gunzip(std::string name, const GzipPlace& place, Source source, ExpansionBounds bounds)
    : Gunzip(std::move(name), std::string_view(), std::move(source), bounds) {
    packed_size_ = place.packed;
    unpacked_size_ = place.unpacked;
    in_member_ = !place.begins_member;
    if (place.begins_member) return;
    is_bare_ = true;
    inflateReset2(stream_.get(), bare_windows);
    if (place.bits > 0) {
        if (!refill()) fail("its gzip data end too early");
        --packed_size_;  // that byte was counted already
        inflatePrime(stream_.get(), static_cast<int>(place.bits), *stream_->next_in >> (8 - place.bits));
        ++stream_->next_in;
        --stream_->avail_in;
    }
    const std::string before = unpack_window(place.text);
    inflateSetDictionary(stream_.get(), reinterpret_cast<const Bytef*>(before.data()), static_cast<uInt>(before.size()));
}

void Gunzip::fail(const std::string& why) const { throw InputError(name_ + ": cannot be unpacked: " + why); }

// Makes sure that there are packed bytes; false at the end of the file.
bool Gunzip::refill() {
    if (stream_->avail_in != 0) return true;
    const std::size_t count = source_(packed_.get(), packed_capacity);
    packed_size_ += count;
    stream_->next_in = reinterpret_cast<Bytef*>(packed_.get());
    stream_->avail_in = static_cast<uInt>(count);
    return count != 0;
}

// Where zlib has not done so.
void Gunzip::pass_end_of_member() {
    if (!is_bare_) return;
    for (std::size_t i = 0; i < member_end_size; ++i) {
        if (!refill()) fail("its gzip data end too early");
        ++stream_->next_in;
        --stream_->avail_in;
    }
    is_bare_ = false;
}

// If it is one, and far from the last. zlib's `data_type` says between which blocks it stands.
void Gunzip::remember_place(std::uint64_t unpacked) {
    constexpr int at_end_of_block = 128;
    constexpr int in_last_block = 64;
    constexpr int unused_bits = 7;
    if (!places_ || !places_->is_due(unpacked)) return;
    GzipPlace place{packed_size_ - stream_->avail_in, unpacked, 0, true, {}};
    if (in_member_) {
        if ((stream_->data_type & at_end_of_block) == 0 || (stream_->data_type & in_last_block) != 0) return;
        std::array<Bytef, gzip_window> before{};
        uInt size = 0;
        if (inflateGetDictionary(stream_.get(), before.data(), &size) != Z_OK) return;
        place.bits = static_cast<unsigned>(stream_->data_type & unused_bits);
        place.begins_member = false;
        place.text = pack_window(before.data(), size);
    }
    places_->add(std::move(place));
}

// Steps to the next member; false when there is none.
bool Gunzip::begin_next_member() {
    for (std::size_t padding = 0; refill(); ++padding) {
        if (*stream_->next_in != 0 || padding == most_padding) {
            if (*stream_->next_in != static_cast<Bytef>(gzip_magic[0])) {
                fail("found other bytes behind its gzip data, expected its end");
            }
            inflateReset2(stream_.get(), gzip_windows);
            in_member_ = true;
            return true;
        }
        ++stream_->next_in;
        --stream_->avail_in;
    }
    return false;
}

void Gunzip::check_bounds() const {
    if (unpacked_size_ > bounds_.most) {
        fail("its text is longer than " + in_groups(bounds_.most) + " bytes, more than is ever unpacked");
    }
    if (unpacked_size_ > bounds_.small && unpacked_size_ / bounds_.ratio > packed_size_) {
        fail("its text is longer than " + in_groups(bounds_.ratio) + " times the file, as no scene's is");
    }
}

std::size_t Gunzip::read(char* to, std::size_t most) {
    assert(most > 0);
    const std::size_t room = std::min<std::size_t>(most, std::numeric_limits<uInt>::max());
    stream_->next_out = reinterpret_cast<Bytef*>(to);
    stream_->avail_out = static_cast<uInt>(room);
    while (stream_->avail_out == room) {
        if (!in_member_ && !begin_next_member()) return 0;
        if (!refill()) fail("its gzip data end too early");
        const int result = inflate(stream_.get(), Z_BLOCK);
        if (result == Z_MEM_ERROR) throw std::bad_alloc();
        if (result == Z_STREAM_END) {
            in_member_ = false;
            pass_end_of_member();
        } else if (result != Z_OK && result != Z_BUF_ERROR) {
            fail("its gzip data are damaged" + (stream_->msg != nullptr ? " (" + std::string(stream_->msg) + ")" : ""));
        }
        remember_place(unpacked_size_ + (room - stream_->avail_out));
    }
    const std::size_t count = room - stream_->avail_out;
    unpacked_size_ += count;
    check_bounds();
    return count;
}

}  // namespace sphereview

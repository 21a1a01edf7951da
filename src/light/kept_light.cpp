#include "light/kept_light.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace sphereview {

namespace {

constexpr std::size_t values_of_byte = 256;
constexpr std::size_t in_byte = 8;
constexpr std::size_t lights_in_word = 64;
constexpr std::size_t words_at_once = 256;

// Row i of 8 x 8 bits becomes column i. Warren, "Hacker's Delight", 7-3.
std::uint64_t transposed(std::uint64_t bits) {
    std::uint64_t swapped = (bits ^ (bits >> 7)) & 0x00AA00AA00AA00AAU;
    bits ^= swapped ^ (swapped << 7);
    swapped = (bits ^ (bits >> 14)) & 0x0000CCCC0000CCCCU;
    bits ^= swapped ^ (swapped << 14);
    swapped = (bits ^ (bits >> 28)) & 0x00000000F0F0F0F0U;
    return bits ^ swapped ^ (swapped << 28);
}

}  // namespace

void KeptLight::begin(const std::vector<std::vector<DirectedLight>>& sets, int side) {
    side_ = static_cast<std::size_t>(side);
    bytes_ = 0;
    pieces_.clear();
    directions_.clear();
    given_up_ = complete_ = false;
    std::size_t most = 0;
    for (const auto& set : sets) {
        auto& directions = directions_.emplace_back();
        for (const DirectedLight& light : set) directions.push_back(light.direction);
        most = std::max(most, directions.size());
    }
    bytes_a_point_ = (most + in_byte - 1) / in_byte;
}

std::size_t KeptLight::bytes_for(std::size_t points, std::size_t lit_points) const {
    return points * sizeof(std::int32_t) + lit_points * bytes_a_point_;
}

bool KeptLight::has_room(std::size_t points, std::size_t lit_points) const {
    return !given_up_ && bytes_ + bytes_for(points, lit_points) <= most_bytes_;
}

void KeptLight::give_up() {
    given_up_ = true;
    bytes_ = 0;
    pieces_ = {};
}

void KeptLight::add(const Block& block, std::span<const std::int32_t> visible, std::span<const FoundLight> found) {
    Piece piece{block, {visible.begin(), visible.end()}, {}, {}};
    const auto width = static_cast<std::size_t>(block.width);
    UninitializedVector<std::uint32_t> ranks(visible.size());
    std::uint32_t rank = 0;
    for (std::size_t i = 0; i < visible.size(); ++i) {
        if (i % width == 0) piece.rows.push_back(rank);
        ranks[i] = rank;
        if (visible[i] >= 0) ++rank;
    }
    piece.bits.resize(rank * bytes_a_point_);
    for (const FoundLight& part : found) add_bits(part, ranks, piece.bits);
    bytes_ += bytes_for(visible.size(), rank);
    pieces_.push_back(std::move(piece));
}

void KeptLight::add_bits(const FoundLight& found, std::span<const std::uint32_t> ranks, std::span<std::uint8_t> all_bits) const {
    // The lights of each set, those that shine nowhere left out.
    std::vector<std::vector<const std::uint64_t*>> of_sets(directions_.size(),
                                                           std::vector<const std::uint64_t*>(bytes_a_point_ * in_byte, nullptr));
    for (const Shining& light : found.shining) of_sets.at(light.set).at(light.light) = light.points.data();
    for (std::size_t set = 0; set < directions_.size(); ++set) {
        const std::size_t first = found.begins[set];
        const std::size_t count = found.begins[set + 1] - first;
        const std::vector<const std::uint64_t*>& lights = of_sets[set];
        parallel_pieces((count + lights_in_word - 1) / lights_in_word, words_at_once, [&](std::size_t begin, std::size_t end) {
            for (std::size_t word = begin; word < end; ++word) {
                for (std::size_t byte = 0; byte < bytes_a_point_; ++byte) {
                    // Eight points of eight lights at a time.
                    for (std::size_t eight = 0; eight < lights_in_word / in_byte; ++eight) {
                        const std::size_t from = word * lights_in_word + eight * in_byte;
                        if (from >= count) break;
                        std::uint64_t bits = 0;
                        for (std::size_t k = 0; k < in_byte; ++k) {
                            const std::uint64_t* points = lights[byte * in_byte + k];
                            if (points != nullptr) bits |= (points[word] >> (eight * in_byte) & 0xFFU) << (k * in_byte);
                        }
                        bits = transposed(bits);
                        for (std::size_t i = from; i < std::min(from + in_byte, count); ++i, bits >>= in_byte) {
                            const std::size_t row = ranks[static_cast<std::size_t>(found.places[first + i])];
                            all_bits[row * bytes_a_point_ + byte] = static_cast<std::uint8_t>(bits);
                        }
                    }
                }
            }
        });
    }
}

std::optional<KeptLight::Shares> KeptLight::shares(const std::vector<std::vector<DirectedLight>>& sets) const {
    if (sets.size() != directions_.size()) return std::nullopt;
    Shares shares;
    for (std::size_t set = 0; set < sets.size(); ++set) {
        // Lights that add nothing are left out of a set: so what is there may be fewer, in the same order.
        const std::vector<glm::dvec3>& directions = directions_[set];
        std::vector<LightVector> of_lights(bytes_a_point_ * in_byte);
        std::size_t at = 0;
        for (const DirectedLight& light : sets[set]) {
            while (at < directions.size() && directions[at] != light.direction) ++at;
            if (at == directions.size()) return std::nullopt;
            of_lights[at++] = light.share;
        }
        std::vector<LightVector>& sums = shares.of_sets.emplace_back(bytes_a_point_ * values_of_byte);
        for (std::size_t byte = 0; byte < bytes_a_point_; ++byte) {
            LightVector* const of_byte = &sums[byte * values_of_byte];
            for (std::size_t bit = 0; bit < in_byte; ++bit) {
                for (std::size_t value = 0; value < std::size_t{1} << bit; ++value) {
                    LightVector& sum = of_byte[value | std::size_t{1} << bit];
                    sum = of_byte[value];
                    sum += of_lights[byte * in_byte + bit];
                }
            }
        }
    }
    return shares;
}

std::vector<LightVector> KeptLight::light(const Piece& piece, const Shares& shares) const {
    const auto width = static_cast<std::size_t>(piece.block.width);
    std::vector<LightVector> lit(piece.visible.size());
    parallel_for(piece.rows.size(), [&](std::size_t row) {
        const std::uint8_t* bits = piece.bits.data() + piece.rows[row] * bytes_a_point_;
        const std::size_t set_of_row = (static_cast<std::size_t>(piece.block.y) + row) % side_ * side_;
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t i = row * width + x;
            if (piece.visible[i] < 0) continue;
            const std::size_t set = set_of_row + (static_cast<std::size_t>(piece.block.x) + x) % side_;
            const LightVector* of_byte = shares.of_sets[set].data();
            LightVector sum;
            for (std::size_t byte = 0; byte < bytes_a_point_; ++byte, of_byte += values_of_byte) sum += of_byte[*bits++];
            lit[i] = sum;
        }
    });
    return lit;
}

}  // namespace sphereview

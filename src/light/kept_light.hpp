// Remembers which lights shine on which points of a picture, so that nothing is decided again when only strengths of lights change.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "base/uninitialized.hpp"
#include "exact/visible.hpp"
#include "light/light_set.hpp"

namespace sphereview {

// The points of a block that one light of a set shines on: a bit for each of the set's points, in their order.
struct Shining {
    std::size_t set = 0;
    std::size_t light = 0;  // its place in the set
    std::vector<std::uint64_t> points;
};

// The light of some points of a block. `places`: the points' places in the block, by sets. `begins`: where each set begins in
// `places`, and the end.
struct FoundLight {
    std::span<const std::int32_t> places;
    std::span<const std::size_t> begins;
    std::vector<Shining> shining;
};

class KeptLight {
public:
    // A bit for each light of each point that shows a sphere, row by row; each point begins a new byte.
    struct Piece {
        Block block;
        UninitializedVector<std::int32_t> visible;
        UninitializedVector<std::uint8_t> bits;
        std::vector<std::size_t> rows;  // how many such points come before each row
    };

    // Keeps at most `most_bytes`. A picture that needs more is not kept at all.
    explicit KeptLight(std::size_t most_bytes) : most_bytes_(most_bytes) {}

    // Begins a picture with these sets of lights and `side` points along a side of a pixel. add() then gets block by block.
    void begin(const std::vector<std::vector<DirectedLight>>& sets, int side);
    // Whether the bits of a block with `points` points, of which `lit_points` show a sphere, fit in.
    bool has_room(std::size_t points, std::size_t lit_points) const;
    // `found`: together all points that show a sphere.
    void add(const Block& block, std::span<const std::int32_t> visible, std::span<const FoundLight> found);
    // There is no room for a block: forgets all.
    void give_up();
    // After the last block.
    void finish() { complete_ = !given_up_; }
    bool is_complete() const { return complete_; }

    const std::vector<Piece>& pieces() const { return pieces_; }
    std::size_t bytes() const { return bytes_; }

    // The sum of the lights of each byte of bits, for each value of that byte.
    struct Shares {
        std::vector<std::vector<LightVector>> of_sets;
    };
    // Nothing if `sets` has a direction that the kept lights have not.
    std::optional<Shares> shares(const std::vector<std::vector<DirectedLight>>& sets) const;
    // The light of each point, row by row: what Lighting::light() returns for these strengths. docs/light.md, "In the window".
    std::vector<LightVector> light(const Piece& piece, const Shares& shares) const;

private:
    // `ranks`: each point's place among the block's points that show a sphere.
    void add_bits(const FoundLight& found, std::span<const std::uint32_t> ranks, std::span<std::uint8_t> all_bits) const;
    std::size_t bytes_for(std::size_t points, std::size_t lit_points) const;

    std::size_t most_bytes_;
    std::size_t bytes_ = 0;
    std::size_t side_ = 1;
    std::size_t bytes_a_point_ = 0;
    std::vector<std::vector<glm::dvec3>> directions_;  // of each set
    std::vector<Piece> pieces_;
    bool given_up_ = false;
    bool complete_ = false;
};

}  // namespace sphereview

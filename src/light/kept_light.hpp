// Which lights shine on which points of a picture: kept, so that the picture need not be decided again where only the strengths of
// its lights change.
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

// Which of a block's points a light of a set shines on: a bit for each of the set's points, in their order.
struct Shining {
    std::size_t set = 0;
    std::size_t light = 0;  // its place in the set
    std::vector<std::uint64_t> points;
};

// What was found of some of a block's points. `places`: theirs in the block, by sets; `begins`: where those of each set begin, and
// the end.
struct FoundLight {
    std::span<const std::int32_t> places;
    std::span<const std::size_t> begins;
    std::vector<Shining> shining;
};

class KeptLight {
public:
    // A bit for each light of each point that shows a sphere, in bytes of their own, in the order of the block's rows.
    struct Piece {
        Block block;
        UninitializedVector<std::int32_t> visible;
        UninitializedVector<std::uint8_t> bits;
        std::vector<std::size_t> rows;  // of each row, how many such points come before it
    };

    // Keeps at most `most_bytes`. A picture that needs more is not kept at all.
    explicit KeptLight(std::size_t most_bytes) : most_bytes_(most_bytes) {}

    // Of a picture with these lights, for each of the points along the sides of a pixel. The blocks come one by one.
    void begin(const std::vector<std::vector<DirectedLight>>& sets, int side);
    // Whether a block with so many points, of which so many show a sphere, is worth counting bits for.
    bool has_room(std::size_t points, std::size_t lit_points) const;
    // `found`: of all points that show a sphere, together.
    void add(const Block& block, std::span<const std::int32_t> visible, std::span<const FoundLight> found);
    // Without room for a block: forgets all.
    void give_up();
    // After the last block.
    void finish() { complete_ = !given_up_; }
    bool is_complete() const { return complete_; }

    const std::vector<Piece>& pieces() const { return pieces_; }
    std::size_t bytes() const { return bytes_; }

    // What the lights add together, for each value of each byte of bits.
    struct Shares {
        std::vector<std::vector<LightVector>> of_sets;
    };
    // Nothing where a light comes from where none did.
    std::optional<Shares> shares(const std::vector<std::vector<DirectedLight>>& sets) const;
    // The light of each point, row by row: what Lighting::light() returns for these strengths. docs/light.md, "In the window".
    std::vector<LightVector> light(const Piece& piece, const Shares& shares) const;

private:
    // `ranks`: of the block's points, among those that show a sphere.
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

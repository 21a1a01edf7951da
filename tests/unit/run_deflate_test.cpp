// The compressor of flat pictures, judged by zlib.
#include "image/run_deflate.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <random>

#include "image/huffman.hpp"

namespace sphereview {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes inflated(const Bytes& stream, std::size_t size) {
    Bytes bytes(size + 1);  // one more, to see that there is none
    uLongf count = bytes.size();
    EXPECT_EQ(uncompress(bytes.data(), &count, stream.data(), stream.size()), Z_OK);
    bytes.resize(count);
    return bytes;
}

// Rows of a PNG: `kinds` colours in runs, rows that mostly repeat the one above.
Bytes flat_rows(std::mt19937_64& random, std::size_t width, std::size_t rows, const RowLayout& layout, unsigned kinds) {
    Bytes data;
    Bytes row;
    for (std::size_t y = 0; y < rows; ++y) {
        if (y == 0 || random() % 3 == 0) {
            row.assign(1, 0);
            while (row.size() < layout.row) {
                const auto kind = static_cast<std::uint8_t>(random() % kinds * 37);
                for (std::size_t n = (1 + random() % (random() % 8 == 0 ? 4 * width : 30)) * layout.pixel; n > 0; --n) {
                    if (row.size() < layout.row) row.push_back(static_cast<std::uint8_t>(kind + n % layout.pixel));
                }
            }
        }
        data.insert(data.end(), row.begin(), row.end());
    }
    return data;
}

TEST(RunDeflate, GivesBackFlatRows) {
    std::mt19937_64 random(1);
    int taken = 0;
    for (int trial = 0; trial < 1500; ++trial) {
        SCOPED_TRACE(trial);
        const std::size_t pixel = 1 + random() % 4;
        const std::size_t width = 1 + random() % (trial % 50 == 0 ? 20'000 : 300);
        const RowLayout layout{pixel, pixel * width + 1};
        const Bytes data = flat_rows(random, width, 1 + random() % 40, layout, 1 + static_cast<unsigned>(random() % 7));
        const auto stream = run_deflate(data, layout);
        if (!stream) continue;
        ++taken;
        ASSERT_EQ(inflated(*stream, data.size()), data);
    }
    EXPECT_GT(taken, 1000);
}

TEST(RunDeflate, TakesWhatIsLongEmptyOrOdd) {
    const Bytes one(1, 7);
    const Bytes zeros(70'000'000, 0);
    for (const RowLayout& layout : {RowLayout{3, 3001}, RowLayout{4, 40'001}, RowLayout{1, 2}, RowLayout{3, 0}}) {
        for (const Bytes& data : {Bytes{}, one, zeros}) {
            const auto stream = run_deflate(data, layout);
            ASSERT_TRUE(stream);
            EXPECT_LT(stream->size(), 40 + data.size() / 500);
            EXPECT_TRUE(inflated(*stream, data.size()) == data);
        }
    }
}

// Literals of very different frequency: their codes would be longer than DEFLATE has them.
TEST(RunDeflate, KeepsCodesShort) {
    Bytes data;
    std::size_t count = 1;
    for (std::uint8_t value = 1; value < 25; ++value) {
        for (std::size_t n = 0; n < count; ++n) {
            data.insert(data.end(), {value, static_cast<std::uint8_t>(255 - n % 3)});
            data.insert(data.end(), 48, 0);
        }
        if (value > 8) count = count * 3 / 2;
    }
    const auto stream = run_deflate(data, {1, 0});
    ASSERT_TRUE(stream);
    EXPECT_EQ(inflated(*stream, data.size()), data);
}

TEST(RunDeflate, LeavesNoiseToOthers) {
    std::mt19937_64 random(2);
    Bytes noise(100'000);
    for (std::uint8_t& byte : noise) byte = static_cast<std::uint8_t>(random());
    EXPECT_FALSE(run_deflate(noise, {3, 3001}));
}

TEST(HuffmanCode, IsCompleteAndBestWithinItsLimit) {
    std::mt19937_64 random(3);
    for (int trial = 0; trial < 2000; ++trial) {
        const int longest = trial % 2 == 0 ? 15 : 7;
        std::vector<std::uint32_t> counts(2 + random() % (longest == 15 ? 285 : 18));
        for (std::uint32_t& count : counts) count = random() % 4 == 0 ? 0 : static_cast<std::uint32_t>(1U << random() % 24);
        const auto used = std::ranges::count_if(counts, [](std::uint32_t count) { return count > 0; });
        const HuffmanCode code = huffman_code(counts, longest);
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            ASSERT_EQ(code.lengths[i] == 0, counts[i] == 0);
            ASSERT_LE(code.lengths[i], longest);
            if (counts[i] > 0) sum += std::uint64_t{1} << (longest - code.lengths[i]);
            for (std::size_t k = 0; k < i; ++k) {
                if (counts[k] > counts[i] && counts[i] > 0) {
                    ASSERT_LE(code.lengths[k], code.lengths[i]);
                }
            }
        }
        ASSERT_EQ(sum, used == 0 ? 0 : std::uint64_t{1} << (longest - (used == 1 ? 1 : 0)));
    }
}

}  // namespace
}  // namespace sphereview

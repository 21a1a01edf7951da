// The four scenes of scenes/, known by the sums of their pixels from an independent implementation in double precision.
#include <gtest/gtest.h>

#include "support/folders.hpp"
#include "support/render.hpp"
#include "support/sha256.hpp"

namespace sphereview::test {
namespace {

struct Known {
    std::string scene;
    std::string sum;  // of the decoded 8-bit RGB pixels
};

std::ostream& operator<<(std::ostream& stream, const Known& known) { return stream << known.scene; }

const std::vector<Known> known_pictures = {
    {"input1", "2be13968e337364ebd1ac24272a8ba810bb149fa52490f8abc30e26a3b138dda"},
    {"input2", "96952c1c9170906926e1bacc586f373ee1ed81fb7c7d81c14ced27702ed63c52"},
    {"input3", "13061ed8953582c860be4dab685991b786d00016edfffd8d233717831392d0b1"},
    {"input4", "f47d8b3825145e19134b10371c92bd3e18107b26a701836e29cfac9b3f1433e1"},
};

class KnownPicture : public testing::TestWithParam<std::tuple<Known, std::string>> {};

TEST_P(KnownPicture, HasTheSumOfAnIndependentImplementation) {
    const auto& [known, backend] = GetParam();
    const Outcome outcome =
        run({"render", source_file(std::string("scenes/") + known.scene) + ".txt", "--backend", backend, "-o", "-"});
    ASSERT_EQ(outcome.status, 0) << outcome;
    const Picture picture = decode_png(outcome.output);
    EXPECT_EQ(picture.channels, 3);
    EXPECT_EQ(picture.bytes.size(), 3'000'000U);
    EXPECT_EQ(sha256(picture.bytes), known.sum);
}

INSTANTIATE_TEST_SUITE_P(Scenes, KnownPicture,
                         testing::Combine(testing::ValuesIn(known_pictures), testing::Values("cpu", "egl", "osmesa", "auto")),
                         [](const auto& test) { return std::get<0>(test.param).scene + "_" + std::get<1>(test.param); });

}  // namespace
}  // namespace sphereview::test

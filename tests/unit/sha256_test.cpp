// Sums as others compute them (FIPS 180-4's examples).
#include "base/sha256.hpp"

#include <gtest/gtest.h>

#include <array>

namespace sphereview {

TEST(Sha256, IsThatOfOthers) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    const std::array<std::string_view, 3> pieces = {"a", "bc", ""};
    std::size_t next = 0;
    EXPECT_EQ(sha256([&] { return pieces.at(next++); }), sha256("abc"));
}

}  // namespace sphereview

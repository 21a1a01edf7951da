// What the readers allocate.
#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"
#include "formats/scene_format.hpp"
#include "unit/largest_allocation.hpp"

namespace sphereview {

TEST(Memory, DoesNotFollowTheClaimedCount) {
    for (const std::string text : {"2000000000\n1 2 3 4 5 6 7\n", "spheres = \"\"\"\n2000000000\n1 2 3 4 5 6 7\n\"\"\"\n"}) {
        take_largest_allocation();
        EXPECT_THROW(parse_scene(text, "s"), InputError);
        EXPECT_LT(take_largest_allocation(), 16U * 1024);
    }
}

TEST(Memory, OfManySpheresIsOneTightAllocation) {
    constexpr std::size_t count = 10'000;
    std::string text = std::to_string(count) + "\n";
    for (std::size_t i = 0; i < count; ++i) text += "255 128 64\n-12.345678901 23.456789012 150.25\n1.2345678901\n";
    take_largest_allocation();
    const Scene scene = parse_scene(text, "s");
    EXPECT_EQ(scene.spheres.size(), count);
    EXPECT_EQ(take_largest_allocation(), count * sizeof(Sphere));
}

}  // namespace sphereview

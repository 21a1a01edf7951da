// The sets of lights.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/mat3x3.hpp>
#include <vector>

#include "light/light_set.hpp"

namespace sphereview::oracle {

namespace {

// The sets of lights are what they were when these numbers were written, with every compiler.
TEST(LightSet, is_the_same_everywhere) {
    const auto sum = [](const std::vector<DirectedLight>& lights) {
        std::uint64_t hash = 0;
        for (const DirectedLight& light : lights) {
            for (const double component : {light.direction.x, light.direction.y, light.direction.z}) {
                hash = hash * 0x100000001b3U + static_cast<std::uint64_t>(static_cast<std::int64_t>(component));
            }
            for (const std::int32_t part : {light.share.x, light.share.y, light.share.z}) {
                hash = hash * 0x100000001b3U + static_cast<std::uint64_t>(part);
            }
        }
        return hash;
    };
    EXPECT_EQ(sum(light_set({}, 16, {}, 0)), 7235032799401254674U);
    EXPECT_EQ(sum(light_set({}, 255, {}, 7)), 12563828551802134336U);
    EXPECT_EQ(sum(light_set({.lights = {}, .sky = 0.5, .sun = Sun{{3.0, -4.0, 12.0}, 0.7}}, 1024, {}, 15)), 9618890243853199149U);
}

// A free surface that faces the key has the brightness 1.07, whatever the number of lights; so has each turned set.
TEST(LightSet, is_as_bright_whatever_its_number) {
    for (const int lights : {16, 17, 64, 255, 256, 1024}) {
        for (int set = 0; set < turned_sets; ++set) {
            const std::vector<DirectedLight> all = light_set({}, lights, {}, set);
            EXPECT_EQ(all.size(), static_cast<std::size_t>(lights));
            const glm::dvec3 key = glm::dvec3(-0.45, 0.75, -0.55) / std::sqrt(0.45 * 0.45 + 0.75 * 0.75 + 0.55 * 0.55);
            double brightness = 0.0;
            for (const DirectedLight& light : all) {
                const glm::dvec3 l(light.share.x, light.share.y, light.share.z);
                const double part = (key.x * l.x + key.y * l.y + key.z * l.z) / light_one;
                if (part > 0.0) brightness += part;
            }
            EXPECT_NEAR(brightness, 1.07, lights < 20 ? 0.25 : lights < 100 ? 0.05 : 0.02) << lights << " lights, set " << set;
        }
    }
}

// No sum of shares leaves 32 bits.
TEST(LightSet, sums_fit) {
    for (const int lights : {fewest_lights, 64, most_lights}) {
        double sum = 0.0;
        for (const DirectedLight& light :
             light_set({.lights = {}, .sky = most_sky, .sun = Sun{{1.0, 0.0, 0.0}, strongest_sun}}, lights, {}, 3)) {
            sum += std::sqrt(std::pow(light.share.x, 2.0) + std::pow(light.share.y, 2.0) + std::pow(light.share.z, 2.0));
        }
        EXPECT_LT(sum, 2147483647.0);
    }
}

TEST(LightSet, beginnings_are_spread_evenly) {
    const std::vector<DirectedLight> all = light_set({}, 256, {}, 0);
    for (const std::size_t count : {16U, 32U, 64U, 128U}) {
        glm::dmat3 sum(0.0);
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec3 l = all[i].direction / 32767.0;
            for (int row = 0; row < 3; ++row) sum[row] += l[row] * l / static_cast<double>(count);
        }
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                EXPECT_NEAR(sum[row][column], row == column ? 1.0 / 3.0 : 0.0, count < 64 ? 0.15 : 0.06) << count;
        }
    }
}

TEST(LightSet, lights_that_add_nothing_are_left_out) {
    EXPECT_EQ(light_set({.lights = {}, .sky = 0.0, .sun = Sun{}}, 64, {}, 0).size(), 1U);
    EXPECT_TRUE(light_set({.lights = {}, .sky = 0.0, .sun = {}}, 64, {}, 0).empty());
}

}  // namespace

}  // namespace sphereview::oracle

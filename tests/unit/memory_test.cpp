// What the readers allocate. This program replaces operator new in order to see it.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>
#include <string>

#include "base/error.hpp"
#include "scene/scene_format.hpp"

namespace {

std::atomic<std::size_t> largest = 0;  // the largest allocation since it was set to 0, in bytes

}  // namespace

void* operator new(std::size_t size) {
    largest = std::max(largest.load(), size);
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace sphereview {

TEST(Memory, DoesNotFollowTheClaimedCount) {
    for (const std::string text : {"2000000000\n1 2 3 4 5 6 7\n", "spheres = \"\"\"\n2000000000\n1 2 3 4 5 6 7\n\"\"\"\n"}) {
        largest = 0;
        EXPECT_THROW(parse_scene(text, "s"), InputError);
        EXPECT_LT(largest.load(), 16U * 1024);
    }
}

TEST(Memory, OfManySpheresIsOneTightAllocation) {
    constexpr std::size_t count = 10'000;
    std::string text = std::to_string(count) + "\n";
    for (std::size_t i = 0; i < count; ++i) text += "255 128 64\n-12.345678901 23.456789012 150.25\n1.2345678901\n";
    largest = 0;
    const Scene scene = parse_scene(text, "s");
    EXPECT_EQ(scene.spheres.size(), count);
    EXPECT_EQ(largest.load(), count * sizeof(Sphere));
}

}  // namespace sphereview

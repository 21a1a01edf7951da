#include "panels/hidden_spheres.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace sphereview {

namespace {

std::size_t counted(const Document& document) {
    return static_cast<std::size_t>(std::ranges::count_if(document.scene().spheres, &Sphere::hidden));
}

}  // namespace

TEST(HiddenSpheres, AreCountedThroughAnyEdits) {
    std::mt19937 random(20260101);
    const auto below = [&](std::size_t end) { return static_cast<std::uint32_t>(random() % end); };
    Document document;
    HiddenSpheres hidden;
    EXPECT_EQ(hidden.count(document), 0U);
    for (int trial = 0; trial < 2000; ++trial) {
        const std::size_t size = document.scene().spheres.size();
        const std::uint32_t what = below(6);
        if (what == 0 || size == 0) {
            const Sphere sphere{.hidden = random() % 2 == 0};
            document.apply(InsertSpheres{{below(size + 1)}, {{sphere, ""}}}, "Add");
        } else if (what == 1) {
            document.apply(RemoveSpheres{{below(size)}}, "Delete");
        } else if (what == 2) {
            document.undo();
        } else if (what == 3) {
            document.redo();
        } else {
            const std::uint32_t number = below(size);
            Sphere sphere = document.scene().spheres[number];
            sphere.hidden = random() % 2 == 0;
            document.apply(ChangeSpheres{{number}, {sphere}}, "Hide");
        }
        if (below(3) == 0) continue;  // several edits between two looks
        ASSERT_EQ(hidden.count(document), counted(document)) << "trial " << trial;
    }
}

}  // namespace sphereview

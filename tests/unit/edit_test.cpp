#include "edit/edit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/random_edit.hpp"
#include "unit/random_scene.hpp"
#include "unit/scene_difference.hpp"

namespace sphereview {

namespace {

constexpr int trials = 3000;

Sphere at(double x) { return {{x, 0.0, 200.0}, 20.0, {}, false}; }

// Spheres at x = 0, 1, 2 ..., those with an odd number named after it.
Scene row(std::uint32_t count) {
    Scene scene;
    for (std::uint32_t i = 0; i < count; ++i) {
        scene.spheres.push_back(at(i));
        if (i % 2 == 1) scene.names[i] = std::to_string(i);
    }
    return scene;
}

std::vector<double> places(const Scene& scene) {
    std::vector<double> x;
    for (const Sphere& sphere : scene.spheres) x.push_back(sphere.center.x);
    return x;
}

using Places = std::vector<double>;
using Names = std::map<std::uint32_t, std::string>;
using Numbers = std::vector<std::uint32_t>;

}  // namespace

TEST(Edit, DoesWhatThePlainWayDoesAndItsInverseTakesItBack) {
    for (int trial = 0; trial < trials; ++trial) {
        SCOPED_TRACE("trial " + std::to_string(trial));
        std::mt19937_64 random(static_cast<std::uint64_t>(trial));
        const Scene before = random_scene(random);
        const Edit edit = random_edit(random, before);
        const Scene after = edited(edit, before);
        Scene scene = before;
        EXPECT_EQ(changes_nothing(edit, scene), difference(after, before).empty());
        Edit inverse = apply(edit, scene);
        ASSERT_EQ(difference(scene, after), "");
        Edit again = apply(std::move(inverse), scene);
        ASSERT_EQ(difference(scene, before), "");
        EXPECT_EQ(again.index(), edit.index());
        apply(std::move(again), scene);
        ASSERT_EQ(difference(scene, after), "");
    }
}

TEST(Edit, SaysWhatNumbersSpheresHaveAfterIt) {
    for (int trial = 0; trial < trials; ++trial) {
        SCOPED_TRACE("trial " + std::to_string(trial));
        std::mt19937_64 random(static_cast<std::uint64_t>(trial));
        Scene scene = random_scene(random);
        // A sphere is known again by its centre.
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) scene.spheres[i].center.x = static_cast<double>(i);
        const Edit edit = random_edit(random, scene);
        if (std::holds_alternative<ReplaceScene>(edit) || std::holds_alternative<ChangeSpheres>(edit)) continue;
        Scene after = edited(edit, scene);
        if (const auto* insert = std::get_if<InsertSpheres>(&edit)) {
            for (const std::uint32_t number : insert->numbers) after.spheres[number].center.x = -1.0;
        }
        const Numbers numbers = random_numbers(random, scene.spheres.size());
        Numbers expected;
        for (std::uint32_t i = 0; i < after.spheres.size(); ++i) {
            const double x = after.spheres[i].center.x;
            if (x >= 0.0 && std::ranges::binary_search(numbers, static_cast<std::uint32_t>(x))) expected.push_back(i);
        }
        EXPECT_EQ(numbers_after(edit, numbers), expected);
    }
    EXPECT_EQ(numbers_after(ReplaceScene{row(3)}, {1, 2, 3, 7}), (Numbers{1, 2}));
    EXPECT_EQ(numbers_after(ChangeSpheres{{1}, {at(7)}}, {0, 1}), (Numbers{0, 1}));
}

TEST(Edit, InsertsAtTheNumbersThatSpheresHaveAfterwards) {
    Scene scene = row(3);
    const Edit inverse = apply(InsertSpheres{{0, 2, 5}, {{at(10), "a"}, {at(11), ""}, {at(12), "c"}}}, scene);
    EXPECT_EQ(places(scene), (Places{10, 0, 11, 1, 2, 12}));
    EXPECT_EQ(scene.names, (Names{{0, "a"}, {3, "1"}, {5, "c"}}));
    EXPECT_EQ(std::get<RemoveSpheres>(inverse).numbers, (Numbers{0, 2, 5}));

    scene = {};
    apply(InsertSpheres{{0, 1}, {{at(5), ""}, {at(6), "b"}}}, scene);
    EXPECT_EQ(places(scene), (Places{5, 6}));
    const Edit insertion = apply(RemoveSpheres{{0, 1}}, scene);
    EXPECT_EQ(scene, Scene{});
    EXPECT_EQ(std::get<InsertSpheres>(insertion).spheres, (std::vector<NamedSphere>{{at(5), ""}, {at(6), "b"}}));
}

TEST(Edit, RemovesAndReordersWithNames) {
    Scene scene = row(6);
    apply(RemoveSpheres{{0, 3, 4}}, scene);
    EXPECT_EQ(places(scene), (Places{1, 2, 5}));
    EXPECT_EQ(scene.names, (Names{{0, "1"}, {2, "5"}}));
    scene = row(6);
    apply(ReorderSphere{1, 4}, scene);
    EXPECT_EQ(places(scene), (Places{0, 2, 3, 4, 1, 5}));
    EXPECT_EQ(scene.names, (Names{{2, "3"}, {4, "1"}, {5, "5"}}));
    apply(ReorderSphere{5, 0}, scene);
    EXPECT_EQ(places(scene), (Places{5, 0, 2, 3, 4, 1}));
    EXPECT_EQ(scene.names, (Names{{0, "5"}, {3, "3"}, {5, "1"}}));
}

TEST(Edit, ConcernsWhatThereIsToSelectAfterwards) {
    EXPECT_EQ(numbers_concerned(ChangeSpheres{{1, 4}, {at(0), at(0)}}), (Numbers{1, 4}));
    EXPECT_EQ(numbers_concerned(InsertSpheres{{2}, {{at(0), ""}}}), (Numbers{2}));
    EXPECT_EQ(numbers_concerned(ReorderSphere{3, 1}), (Numbers{1}));
    EXPECT_EQ(numbers_concerned(RenameSphere{3, "a"}), (Numbers{3}));
    for (const Edit& edit : {Edit(RemoveSpheres{{1}}), Edit(ChangeCamera{}), Edit(ChangeBackground{}), Edit(ReplaceScene{})}) {
        EXPECT_EQ(numbers_concerned(edit), Numbers{});
    }
}

// A million named spheres: what copies once too often for each of them would take minutes.
TEST(Edit, TakesManySpheresInOnePass) {
    constexpr std::uint32_t count = 1'000'000;
    const Scene before = row(count);
    Scene scene = before;
    RemoveSpheres odd;
    for (std::uint32_t i = 1; i < count; i += 2) odd.numbers.push_back(i);
    Edit inverse = apply(std::move(odd), scene);
    EXPECT_EQ(scene.spheres.size(), count / 2);
    EXPECT_TRUE(scene.names.empty());
    apply(std::move(inverse), scene);
    EXPECT_EQ(difference(scene, before), "");
}

// What is moved keeps its place in memory.
TEST(Edit, CopiesNoSceneAndNoList) {
    Scene scene = row(10);
    const Sphere* spheres = scene.spheres.data();
    ChangeSpheres change{{3, 4}, {at(7), at(8)}};
    const std::uint32_t* numbers = change.numbers.data();
    const Edit inverse = apply(std::move(change), scene);
    EXPECT_EQ(scene.spheres.data(), spheres);
    EXPECT_EQ(std::get<ChangeSpheres>(inverse).numbers.data(), numbers);
    const Edit old = apply(ReplaceScene{row(3)}, scene);
    EXPECT_EQ(std::get<ReplaceScene>(old).scene.spheres.data(), spheres);
}

}  // namespace sphereview

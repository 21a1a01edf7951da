// What the random sequences of edit_test.cpp do not look at.
#include "edit/document.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace sphereview {

namespace {

using Numbers = std::vector<std::uint32_t>;

Sphere at(double x) { return {{x, 0.0, 200.0}, 20.0, {}, false}; }

Scene row(std::uint32_t count) {
    Scene scene;
    for (std::uint32_t i = 0; i < count; ++i) scene.spheres.push_back(at(i));
    return scene;
}

Edit move(std::uint32_t number, double x) { return ChangeSpheres{{number}, {at(x)}}; }

// All of the first spheres, put at other places.
ChangeSpheres change_of(std::uint32_t count, double first_x, double step) {
    ChangeSpheres edit;
    for (std::uint32_t i = 0; i < count; ++i) {
        edit.numbers.push_back(i);
        edit.spheres.push_back(at(first_x + step * i));
    }
    return edit;
}

double x_of(const Document& document, std::size_t number) { return document.scene().spheres[number].center.x; }

}  // namespace

TEST(Document, FollowsTheSpheresOfAStepAsTheirNumbersChange) {
    Document document(row(4));
    document.apply(move(3, 9), "x", 1);
    EXPECT_EQ(document.apply(RemoveSpheres{{0}}, "x", 1), Numbers{});
    EXPECT_EQ(document.apply(ReorderSphere{2, 0}, "x", 1), Numbers{0});
    EXPECT_EQ(document.undo(), (Numbers{0, 3}));
    EXPECT_EQ(document.scene(), row(4));
    EXPECT_EQ(document.redo(), Numbers{0});
    EXPECT_EQ(x_of(document, 0), 9.0);
    document.apply(InsertSpheres{{3}, {{at(1), ""}}}, "Duplicate", 2);
    document.apply(move(3, 5), "Move", 2);
    EXPECT_EQ(document.undo_name(), "Duplicate");
    EXPECT_EQ(document.undo(), Numbers{});
    EXPECT_EQ(document.redo(), Numbers{3});
}

TEST(Document, TakesWhatChangesNothingForNoStep) {
    Document document(row(2));
    document.apply(move(0, 9), "Move");
    document.undo();
    const std::uint64_t revision = document.revision();
    EXPECT_EQ(document.apply(move(1, 1), "Move"), Numbers{1});
    document.apply(ReplaceScene{row(2)}, "Reload");
    EXPECT_EQ(document.revision(), revision);
    EXPECT_FALSE(document.can_undo());
    EXPECT_TRUE(document.can_redo());
}

TEST(Document, ForgetsAGestureThatEndsWhereItBegan) {
    Document document(row(2));
    document.apply(move(1, 4), "First");
    document.mark_saved();
    document.apply(move(0, 4), "Move", 1);
    document.apply(move(0, 5), "Move", 1);
    EXPECT_TRUE(document.is_changed());
    document.apply(move(0, 0), "Move", 1);
    EXPECT_FALSE(document.is_changed());
    EXPECT_EQ(document.undo_name(), "First");
    document.apply(move(0, 6), "Move", 1);
    EXPECT_EQ(document.undo_name(), "Move");
    document.undo();
    EXPECT_FALSE(document.is_changed());
}

TEST(Document, ForgetsTheOldestStepsForWantOfMemory) {
    constexpr std::size_t bytes = 100'000;
    Document document(row(100), bytes);
    for (int step = 1; step <= 100; ++step) {
        document.apply(change_of(100, step * 1000.0, 1.0), "Move all");
        if (step == 95) document.mark_saved();
    }
    int steps = 0;
    bool saved = false;
    for (; document.can_undo(); ++steps) {
        document.undo();
        saved = saved || !document.is_changed();
    }
    EXPECT_GT(steps, 10);
    EXPECT_LT(steps, 25);
    EXPECT_TRUE(saved);
    EXPECT_TRUE(document.is_changed());
    EXPECT_EQ(x_of(document, 0), (100 - steps) * 1000.0);

    Document small(row(100), 1);
    small.apply(ReplaceScene{row(200)}, "a");
    small.apply(ReplaceScene{row(300)}, "b");
    EXPECT_EQ(small.undo_name(), "b");
    small.undo();
    EXPECT_EQ(small.scene(), row(200));
    EXPECT_FALSE(small.can_undo());
    EXPECT_TRUE(small.is_changed());
}

TEST(Document, SaysThatEverythingChangedWhereItCannotKnow) {
    const auto everything = [](const ChangesSince& changes) {
        return changes.order && changes.geometry && changes.camera && changes.background && changes.spheres.empty();
    };
    Document document(row(1000));
    const Document other(row(1000));
    const std::uint64_t begin = document.revision();
    EXPECT_TRUE(everything(document.changes_since(0)));
    EXPECT_TRUE(everything(document.changes_since(other.revision())));
    for (std::size_t i = 0; i < ChangeLog::most_changes; ++i) document.apply(move(0, -1.0 - static_cast<double>(i)), "Move", 1);
    EXPECT_EQ(document.changes_since(begin).spheres, Numbers{0});
    const std::uint64_t late = document.revision();
    document.apply(move(1, -1.0), "Move");
    EXPECT_TRUE(everything(document.changes_since(begin)));
    // The record of spheres is bounded, too, but a change of all is always there.
    ChangeSpheres all = change_of(1000, 0.5, 0.0);
    for (int i = 0; i < 100; ++i) {
        const std::uint64_t before = document.revision();
        for (Sphere& sphere : all.spheres) ++sphere.color.r;
        document.apply(all, "Colour all", 9);
        EXPECT_EQ(document.changes_since(before).spheres.size(), 1000U);
    }
    EXPECT_TRUE(everything(document.changes_since(late)));
}

TEST(Document, TakesAChangeOfVeryManyForOneOfAll) {
    constexpr std::size_t count = ChangeLog::most_spheres + 10;
    Document document(row(count));
    const Scene before = document.scene();
    ChangeSpheres edit = change_of(count - 5, 0.0, 1.0);
    for (Sphere& sphere : edit.spheres) sphere.color.r ^= 1;
    const std::uint64_t begin = document.revision();
    document.apply(edit, "Recolour", 1);
    ChangesSince changes = document.changes_since(begin);
    EXPECT_FALSE(changes.order);
    EXPECT_FALSE(changes.geometry) << "colours alone";
    ASSERT_EQ(changes.spheres.size(), count);
    EXPECT_EQ(changes.spheres.front(), 0U);
    EXPECT_EQ(changes.spheres.back(), count - 1);
    const std::uint64_t recolored = document.revision();
    edit.spheres[7].radius *= 2.0;
    document.apply(edit, "Change", 1);
    changes = document.changes_since(recolored);
    EXPECT_TRUE(changes.geometry);
    EXPECT_EQ(changes.spheres.size(), count);
    document.apply(move(3, 0.25), "Move");
    EXPECT_EQ(document.changes_since(begin).spheres.size(), count);
    document.undo();
    document.undo();
    EXPECT_EQ(document.scene(), before) << "to the bit, in one step of a gesture";
    EXPECT_FALSE(document.can_undo());
}

TEST(Document, TellsWhenNamesMayHaveChanged) {
    Document document(row(5));
    std::uint64_t known = document.names_revision();
    const auto changed = [&] { return std::exchange(known, document.names_revision()) != known; };
    document.apply(move(1, 0.5), "Move");
    EXPECT_FALSE(changed());
    document.apply(RenameSphere{1, "sun"}, "Rename");
    EXPECT_TRUE(changed());
    document.undo();
    EXPECT_TRUE(changed());
    document.undo();
    EXPECT_FALSE(changed());
    document.apply(RemoveSpheres{{2}}, "Delete");
    EXPECT_TRUE(changed());
    document.apply(ReorderSphere{0, 1}, "Reorder");
    EXPECT_TRUE(changed());
}

TEST(Document, ItsHistoryIsBoundedBothWays) {
    constexpr std::size_t most = 100'000;
    Document document(row(1), most);
    EXPECT_EQ(document.most_history_bytes(), most);
    for (int step = 0; step < 20; ++step) {
        InsertSpheres insert;
        const auto count = static_cast<std::uint32_t>(document.scene().spheres.size());
        for (std::uint32_t i = 0; i < 200; ++i) insert.numbers.push_back(count + i);
        insert.spheres.resize(200);
        document.apply(insert, "Add");
    }
    EXPECT_LT(document.history_bytes(), most) << "to take them out again needs little";
    for (int step = 0; step < 20; ++step) {
        document.undo();
        EXPECT_LE(document.history_bytes(), most);
    }
    EXPECT_EQ(document.scene().spheres.size(), 1U);
    EXPECT_GT(document.history_bytes(), most / 2) << "to put them in again needs the spheres";
    int redone = 0;
    for (; document.can_redo(); ++redone) {
        document.redo();
        EXPECT_LE(document.history_bytes(), most);
    }
    EXPECT_GT(redone, 2);
    EXPECT_LT(redone, 20) << "the farthest were forgotten";
    EXPECT_TRUE(document.is_changed());
    document.undo();
    EXPECT_EQ(document.scene().spheres.size(), 1U + 200U * (static_cast<std::size_t>(redone) - 1U));
}

TEST(Document, NeverGivesTwoScenesOneRevision) {
    Document first(row(1));
    Document second(row(2));
    EXPECT_NE(first.revision(), second.revision());
    Document copy = first;
    first.apply(move(0, 1), "a");
    copy.apply(move(0, 2), "b");
    EXPECT_NE(first.revision(), copy.revision());
    EXPECT_GT(first.revision(), 0U);
}

}  // namespace sphereview

// Edits and their inverses; and any random sequence of edits, undone and redone, gives back the scenes that were, while the record
// of changes tells what differs.
#include "edit/edit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

#include "edit/document.hpp"
#include "scene/scene.hpp"
#include "support/trials.hpp"
#include "unit/random_edit.hpp"
#include "unit/random_scene.hpp"
#include "unit/scene_difference.hpp"

namespace sphereview {

namespace {

constexpr int trials = test::trials(3000);

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

TEST(Edit, ConcernsWhatThereIsToSelectAfterwards) {
    EXPECT_EQ(numbers_concerned(ChangeSpheres{{1, 4}, {at(0), at(0)}}), (Numbers{1, 4}));
    EXPECT_EQ(numbers_concerned(InsertSpheres{{2}, {{at(0), ""}}}), (Numbers{2}));
    EXPECT_EQ(numbers_concerned(ReorderSphere{3, 1}), (Numbers{1}));
    EXPECT_EQ(numbers_concerned(RenameSphere{3, "a"}), (Numbers{3}));
    for (const Edit& edit :
         {Edit(RemoveSpheres{{1}}), Edit(ChangeCamera{}), Edit(ChangeBackground{}), Edit(ChangeLight{}), Edit(ReplaceScene{})}) {
        EXPECT_EQ(numbers_concerned(edit), Numbers{});
    }
}

// A number, a whole number and a word of each sphere that say its x, so that values that stay behind are seen.
Scene row_with_values(std::uint32_t count) {
    Scene scene = row(count);
    std::vector<double> numbers;
    std::vector<std::int32_t> wholes;
    Labels labels;
    for (std::uint32_t i = 0; i < count; ++i) {
        numbers.push_back(i);
        wholes.push_back(static_cast<std::int32_t>(i));
        labels.words.push_back(std::to_string(i));
        labels.numbers.push_back(i);
    }
    scene.properties = {{"number", numbers}, {"whole", wholes}, {"word", labels}};
    return scene;
}

TEST(Edit, KeepsTheValuesOfSpheresInStep) {
    for (int trial = 0; trial < trials; ++trial) {
        SCOPED_TRACE("trial " + std::to_string(trial));
        std::mt19937_64 random(static_cast<std::uint64_t>(trial));
        const Scene before = row_with_values(static_cast<std::uint32_t>(below(random, 8)));
        Edit edit = random_edit(random, before);
        if (std::holds_alternative<ReplaceScene>(edit) || std::holds_alternative<ChangeSpheres>(edit)) continue;
        // What comes in has no values, or some of another scene.
        if (auto* const insert = std::get_if<InsertSpheres>(&edit)) {
            for (std::size_t i = 0; i < insert->spheres.size(); ++i) {
                insert->spheres[i].sphere.center.x = -1.0;
                if (trial % 2 == 0) insert->spheres[i].sphere.center.x = 100.0 + static_cast<double>(i);
            }
            Labels words;
            std::vector<float> numbers;
            for (std::uint32_t i = 0; i < insert->spheres.size() && trial % 2 == 0; ++i) {
                words.words.push_back(std::to_string(100 + i));
                words.numbers.push_back(i);
                numbers.push_back(100.0F + static_cast<float>(i));
            }
            if (trial % 2 == 0) insert->properties = {{"word", words}, {"number", numbers}, {"whole", numbers}, {"other", words}};
        }
        Scene scene = before;
        Edit inverse = apply(std::move(edit), scene);
        const Scene after = scene;
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
            const double x = scene.spheres[i].center.x;
            const std::string expected = x < 0.0 ? "" : std::to_string(static_cast<int>(x));
            for (const Property& property : scene.properties) {
                ASSERT_EQ(size_of(property), scene.spheres.size());
                EXPECT_EQ(text_at(property, i), expected) << property.name;
            }
        }
        Edit again = apply(std::move(inverse), scene);
        ASSERT_TRUE(scene == before);
        apply(std::move(again), scene);
        ASSERT_TRUE(scene == after);
    }
}

// Many named spheres: what copies once too often for each of them would take minutes.
TEST(Edit, TakesManySpheresInOnePass) {
    constexpr std::uint32_t count = 200'000;
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

namespace {

bool changes_order(const Edit& edit, const Scene& before) {
    if (const auto* replace = std::get_if<ReplaceScene>(&edit)) return replace->scene.spheres.size() != before.spheres.size();
    return std::holds_alternative<InsertSpheres>(edit) || std::holds_alternative<RemoveSpheres>(edit) ||
           std::holds_alternative<ReorderSphere>(edit);
}

// What the document should be: a list of whole scenes.
class Model {
public:
    explicit Model(const Scene& scene) : states_{{scene, "", false}} {}

    const Scene& scene() const { return states_[now_].scene; }

    void apply(const Edit& edit, const std::string& name, std::uint64_t gesture) {
        Scene after = edited(edit, scene());
        if (changes_nothing(edit, scene())) return;  // edit_test.cpp has looked at that
        const bool order = changes_order(edit, scene());
        if (gesture != 0 && gesture == open_gesture_) {
            states_[now_].scene = std::move(after);
            states_[now_].order = states_[now_].order || order;
        } else {
            states_.resize(now_ + 1);
            if (saved_ > static_cast<int>(now_)) saved_ = -1;
            states_.push_back({std::move(after), name, order});
            ++now_;
        }
        open_gesture_ = gesture;
        if (order) order_changed();
    }
    void undo() {
        if (now_ == 0) return;
        if (states_[now_].order) order_changed();
        --now_;
        open_gesture_ = 0;
    }
    void redo() {
        if (now_ + 1 == states_.size()) return;
        ++now_;
        if (states_[now_].order) order_changed();
        open_gesture_ = 0;
    }
    void mark_saved() { saved_ = static_cast<int>(now_), open_gesture_ = 0; }
    void mark_unsaved() { saved_ = -1; }

    // A document may forget a gesture that ended where it began; this one waits until it is told.
    void forget_idle_gesture(const Document& document) {
        if (now_ == 0 || document.undo_name() == states_[now_].name) return;
        ASSERT_EQ(difference(states_[now_].scene, states_[now_ - 1].scene), "") << "a step that did something is gone";
        states_.pop_back();
        --now_;
        open_gesture_ = 0;
    }

    void expect_same(const Document& document) const {
        ASSERT_EQ(difference(document.scene(), scene()), "");
        ASSERT_EQ(document.can_undo(), now_ > 0);
        ASSERT_EQ(document.can_redo(), now_ + 1 < states_.size());
        ASSERT_EQ(document.undo_name(), states_[now_].name);
        ASSERT_EQ(document.redo_name(), document.can_redo() ? states_[now_ + 1].name : "");
        ASSERT_EQ(document.is_changed(), saved_ != static_cast<int>(now_));
    }

    // Scenes that somebody might have made a picture of.
    void remember(const Document& document) {
        if (!remembered_.empty() && remembered_.back().revision == document.revision()) {
            ASSERT_EQ(difference(document.scene(), remembered_.back().scene), "") << "another scene, the same revision";
            return;
        }
        ASSERT_TRUE(remembered_.empty() || remembered_.back().revision < document.revision());
        remembered_.push_back({document.revision(), document.scene(), false});
        most_spheres_ = std::max(most_spheres_, document.scene().spheres.size());
    }

    void expect_changes(const Document& document, std::size_t which) const {
        const Remembered& old = remembered_[which % remembered_.size()];
        const ChangesSince changes = document.changes_since(old.revision);
        const Scene& now = document.scene();
        if (changes.order && changes.camera && changes.background && changes.light &&
            may_be_forgotten(document.revision() - old.revision))
            return;
        ASSERT_EQ(changes.camera, !same_bits(old.scene.camera, now.camera));
        ASSERT_EQ(changes.background, old.scene.background != now.background);
        ASSERT_EQ(changes.light, !same_bits(old.scene.light, now.light));
        if (changes.order) {
            ASSERT_TRUE(old.order_changed_since);
            if (!changes.came.empty() || !changes.went.empty()) expect_others_kept(changes, old.scene, now);
            return;
        }
        ASSERT_TRUE(changes.came.empty() && changes.went.empty());
        ASSERT_EQ(old.scene.spheres.size(), now.spheres.size());
        std::vector<std::uint32_t> differing;
        bool geometry = false;
        for (std::uint32_t i = 0; i < now.spheres.size(); ++i) {
            const Sphere& a = old.scene.spheres[i];
            const Sphere& b = now.spheres[i];
            if (same_bits(a, b)) continue;
            differing.push_back(i);
            geometry = geometry || a.hidden != b.hidden || !same_bits(a.center, b.center) || !same_bits(a.radius, b.radius);
        }
        ASSERT_EQ(changes.spheres, differing);
        ASSERT_EQ(changes.geometry, geometry);
        ASSERT_EQ(changes.none(), differing.empty() && !changes.camera && !changes.background && !changes.light);
    }
    std::size_t remembered() const { return remembered_.size(); }

private:
    struct State {
        Scene scene;
        std::string name;  // of the step that led here
        bool order;        // whether that changed the order
    };
    struct Remembered {
        std::uint64_t revision;
        Scene scene;
        bool order_changed_since;
    };

    // What is left of the old spheres without those that went are the new ones without those that came.
    static void expect_others_kept(const ChangesSince& changes, const Scene& old, const Scene& now) {
        ASSERT_TRUE(changes.spheres.empty());
        std::vector<Sphere> stayed;
        for (std::uint32_t i = 0; i < old.spheres.size(); ++i) {
            if (!std::ranges::binary_search(changes.went, i)) stayed.push_back(old.spheres[i]);
        }
        std::size_t next = 0;
        for (std::uint32_t i = 0; i < now.spheres.size(); ++i) {
            if (std::ranges::binary_search(changes.came, i)) continue;
            ASSERT_LT(next, stayed.size());
            ASSERT_TRUE(same_bits(stayed[next++], now.spheres[i])) << i;
        }
        ASSERT_EQ(next, stayed.size());
    }

    // Whether so many changes, each of no more spheres than a scene ever had, can be more than a record holds.
    bool may_be_forgotten(std::uint64_t changes) const {
        return changes > ChangeLog::most_changes || changes * most_spheres_ > ChangeLog::most_spheres;
    }

    void order_changed() {
        for (Remembered& old : remembered_) old.order_changed_since = true;
    }

    std::vector<State> states_;
    std::size_t now_ = 0;
    int saved_ = 0;  // -1: none
    std::uint64_t open_gesture_ = 0;
    std::vector<Remembered> remembered_;
    std::size_t most_spheres_ = 0;
};

// A gesture goes on with the same spheres, or with anything.
Edit random_part(std::mt19937_64& random, const Scene& scene, const Edit& last) {
    const auto* change = std::get_if<ChangeSpheres>(&last);
    if (change == nullptr || random() % 3 == 0) return random_edit(random, scene);
    if (!change->numbers.empty() && change->numbers.back() >= scene.spheres.size()) return random_edit(random, scene);
    ChangeSpheres next{change->numbers, {}};
    for (const std::uint32_t number : next.numbers) {
        next.spheres.push_back(scene.spheres[number]);
        next.spheres.back().center.x = static_cast<double>(random() % 3);
    }
    return next;
}

void play(std::uint64_t seed, int operations) {
    std::mt19937_64 random(seed);
    const Scene begin = random() % 3 == 0 ? Scene{} : random_scene(random);
    Document document(begin);
    Model model(begin);
    model.remember(document);
    Edit last = ChangeBackground{};
    for (int i = 0; i < operations; ++i) {
        SCOPED_TRACE("operation " + std::to_string(i));
        const auto times = [&] { return random() % 8 == 0 ? random() % 30 : 1; };  // now and then to the very ends
        const std::uint64_t kind = random() % 24;
        if (kind == 0) {
            document.mark_saved(), model.mark_saved();
        } else if (kind == 1) {
            if (random() % 4 == 0) document.mark_unsaved(), model.mark_unsaved();
        } else if (kind < 7) {
            for (std::uint64_t n = times(); n > 0; --n) document.undo(), model.undo();
        } else if (kind < 11) {
            for (std::uint64_t n = times(); n > 0; --n) document.redo(), model.redo();
        } else {
            const std::uint64_t gesture = kind < 14 ? 0 : 1 + random() % 20 / 19;
            last = gesture == 0 ? random_edit(random, document.scene()) : random_part(random, document.scene(), last);
            const std::string name = "step " + std::to_string(i);
            model.apply(last, name, gesture);
            document.apply(last, name, gesture);
            model.forget_idle_gesture(document);
        }
        model.expect_same(document);
        model.remember(document);
        model.expect_changes(document, model.remembered() - 1);
        for (int n = 0; n < 6; ++n) model.expect_changes(document, random());
        if (testing::Test::HasFatalFailure()) return;
    }
    // All the way back, and forth again.
    while (document.can_undo() && !testing::Test::HasFatalFailure()) document.undo(), model.undo(), model.expect_same(document);
    EXPECT_EQ(difference(document.scene(), begin), "");
    while (document.can_redo() && !testing::Test::HasFatalFailure()) document.redo(), model.redo(), model.expect_same(document);
}

}  // namespace

TEST(EditHistory, GivesBackEqualScenesAndTellsWhatDiffers) {
    constexpr std::uint64_t sequences = test::is_sanitized ? 8 : 80;
    for (std::uint64_t seed = 1; seed <= sequences; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        play(seed, 250);
        if (HasFatalFailure() || HasNonfatalFailure()) return;
    }
}

}  // namespace sphereview

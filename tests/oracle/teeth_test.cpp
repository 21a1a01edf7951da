// The comparison can fail: wrong definitions, the textbook formula in float and uncertified pictures are all noticed.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iostream>

#include "oracle/backends.hpp"
#include "oracle/oracle.hpp"

namespace sphereview::oracle {

namespace {

using Answers = std::vector<std::int32_t>;

// Enough of all kinds for each mistake to show.
Trials some_trials() {
    Trials trials;
    for (const Trials& all : {touching_trials(), range_trials()}) {
        for (std::size_t i = 0; i < all.size(); i += 5) {
            if (all[i].size.width * all[i].size.height < 2000) trials.push_back(all[i]);
        }
    }
    for (std::uint64_t i = 0; i < 20; ++i) {
        trials.push_back(random_trial(i));
        trials.push_back(lattice_trial(i));
        trials.push_back(near_miss_trial(i));
    }
    return trials;
}

// In how many of the trials the answers differ from the oracle's.
std::size_t caught(const Trials& trials, const std::function<Answers(const Trial&)>& answers) {
    std::size_t count = 0;
    for (const Trial& trial : trials) {
        if (!difference(trial, "a wrong picture", picture(trial.scene, trial.size), answers(trial)).empty()) ++count;
    }
    return count;
}

void expect_caught(const std::string& mistake, const std::function<Answers(const Trial&)>& answers) {
    const Trials trials = some_trials();
    const std::size_t count = caught(trials, answers);
    std::cout << mistake << ": noticed in " << count << " of " << trials.size() << " scenes\n";
    EXPECT_GT(count, 0U) << mistake;
    EXPECT_LT(count, trials.size()) << mistake << ": and it is wrong everywhere, so this proves little";
}

// b^2 - 4 a c in float, as in any tutorial.
Answers textbook(const Trial& trial) {
    const Camera& camera = trial.scene.camera;
    const auto m = static_cast<double>(trial.size.shorter_side());
    Answers numbers;
    for (int y = 0; y < trial.size.height; ++y) {
        for (int x = 0; x < trial.size.width; ++x) {
            const glm::vec3 d(camera.center - camera.eye + (2 * x + 1 - trial.size.width) / m * camera.right +
                              (trial.size.height - 1 - 2 * y) / m * camera.up);
            float nearest = INFINITY;
            std::int32_t number = -1;
            for (std::size_t i = 0; i < trial.scene.spheres.size(); ++i) {
                const Sphere& sphere = trial.scene.spheres[i];
                const glm::vec3 o(camera.eye - sphere.center);
                const auto r = static_cast<float>(sphere.radius);
                const float a = d.x * d.x + d.y * d.y + d.z * d.z;
                const float b = 2.0F * (d.x * o.x + d.y * o.y + d.z * o.z);
                const float discriminant = b * b - 4.0F * a * (o.x * o.x + o.y * o.y + o.z * o.z - r * r);
                if (sphere.hidden || !(discriminant >= 0.0F)) continue;
                const float near = (-b - std::sqrt(discriminant)) / (2.0F * a);
                const float far = (-b + std::sqrt(discriminant)) / (2.0F * a);
                const float t = near > 0.0F ? near : far;
                if (!(t > 0.0F && t < nearest)) continue;
                nearest = t;
                number = static_cast<std::int32_t>(i);
            }
            numbers.push_back(number);
        }
    }
    return numbers;
}

TEST(Teeth, ties_that_go_to_the_last) {
    expect_caught("the last of equals", [](const Trial& t) { return picture(t.scene, t.size, {.first_of_equals = false}); });
}

TEST(Teeth, tangents_that_miss) {
    expect_caught("tangents miss", [](const Trial& t) { return picture(t.scene, t.size, {.tangent_hits = false}); });
}

TEST(Teeth, hits_at_the_eye) {
    expect_caught("a hit at t = 0", [](const Trial& t) { return picture(t.scene, t.size, {.zero_is_positive = true}); });
}

TEST(Teeth, the_near_root_from_inside) {
    expect_caught("near root", [](const Trial& t) { return picture(t.scene, t.size, {.near_root_from_inside = true}); });
}

TEST(Teeth, the_textbook_formula_in_float) { expect_caught("b^2 - 4ac in float", textbook); }

TEST(Teeth, pictures_that_are_not_certified) {
    for (const Backend backend : tested_backends()) {
        OpenBackend open = opened(backend);
        expect_caught("not certified, " + open.description, [&](const Trial& t) { return visible_spheres(open, t, false); });
    }
}

TEST(Teeth, one_wrong_pixel) {
    const Trial trial = random_trial(3);
    const Answers right = picture(trial.scene, trial.size);
    EXPECT_EQ(difference(trial, "the same", right, right), "");
    for (std::size_t i = 0; i < right.size(); ++i) {
        Answers wrong = right;
        wrong[i] = right[i] == 0 ? -1 : 0;
        const std::string at = "pixel " + std::to_string(i % static_cast<std::size_t>(trial.size.width)) + "," +
                               std::to_string(i / static_cast<std::size_t>(trial.size.width)) + ":";
        ASSERT_NE(difference(trial, "changed", right, wrong).find(at), std::string::npos);
    }
}

}  // namespace

}  // namespace sphereview::oracle

// The comparison can fail: wrong definitions, the textbook formula in float and uncertified pictures are all noticed; so are
// lists of tiles that lack a sphere or let a walk end too soon.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <utility>

#include "cpu/cpu_renderer.hpp"
#include "oracle/backends.hpp"
#include "oracle/long_filter.hpp"
#include "oracle/oracle.hpp"
#include "tiles/pixel_range.hpp"

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

// Trials and the oracle's pictures of them.
struct Proven {
    Trials trials;
    std::vector<Answers> pictures;
};

Proven proven(Trials trials) {
    Proven all{std::move(trials), {}};
    for (const Trial& trial : all.trials) all.pictures.push_back(picture(trial.scene, trial.size));
    return all;
}

// In how many of the trials the answers differ from the oracle's.
std::size_t caught(const Proven& proven, const std::function<Answers(const Trial&)>& answers) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < proven.trials.size(); ++i) {
        const Trial& trial = proven.trials[i];
        if (!difference(trial, "a wrong picture", proven.pictures[i], answers(trial)).empty()) ++count;
    }
    return count;
}

const Proven& proven_trials() {
    static const Proven some = proven(some_trials());
    return some;
}

void expect_caught(const std::string& mistake, const std::function<Answers(const Trial&)>& answers,
                   const Proven& among = proven_trials()) {
    const std::size_t count = caught(among, answers);
    std::cout << mistake << ": noticed in " << count << " of " << among.trials.size() << " scenes\n";
    EXPECT_GT(count, 0U) << mistake;
    EXPECT_LT(count, among.trials.size()) << mistake << ": and it is wrong everywhere, so this proves little";
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

using Change = std::function<void(CandidateLists&, const Trial&)>;

// What the resolver makes of the lists, after a change to them.
Answers resolved(const Trial& trial, const TileCosts& costs, const Change& change) {
    const DrawnSpheres drawn = drawn_spheres(trial.scene);
    CandidateLists lists = build_lists(drawn, trial.scene.camera, trial.size, with_small_budget(costs));
    change(lists, trial);
    const Block all{0, 0, trial.size.width, trial.size.height};
    Answers numbers(static_cast<std::size_t>(all.width) * static_cast<std::size_t>(all.height), doubtful_background);
    Resolver(trial.scene, drawn, trial.size, &lists).certify(all, numbers);
    return numbers;
}

struct Listed {
    Candidate candidate;
    PixelRange tile;      // its pixels
    std::uint32_t after;  // how many follow in the list
};

// Leaves only the candidates for which keep(Listed) is true.
template <typename Keep>
void leave(CandidateLists& lists, const Keep& keep) {
    const CandidateLists all = lists;
    lists.candidates.clear();
    for (std::uint32_t tile = 0; tile + 1 < all.begins.size(); ++tile) {
        lists.begins[tile] = static_cast<std::uint32_t>(lists.candidates.size());
        const TileLevel* level = nullptr;
        for (const TileLevel& each : all.levels) {
            if (each.first <= tile && (level == nullptr || each.first >= level->first)) level = &each;
        }
        for (std::uint32_t i = all.begins[tile]; i < all.begins[tile + 1]; ++i) {
            const int side = 1 << level->shift;
            const int x = static_cast<int>(tile - level->first) % level->across * side;
            const int y = static_cast<int>(tile - level->first) / level->across * side;
            const Listed listed{all.candidates[i], {x, y, x + side - 1, y + side - 1}, all.begins[tile + 1] - i - 1};
            if (keep(listed)) lists.candidates.push_back(listed.candidate);
        }
    }
    lists.begins.back() = static_cast<std::uint32_t>(lists.candidates.size());
}

// As if the pixels that a sphere can cover ended so many too early, or late, on each side.
void shrink(CandidateLists& lists, const Trial& trial, const PixelRange& by) {
    const DrawnSpheres drawn = drawn_spheres(trial.scene);
    const PixelPlanes planes(trial.scene.camera, trial.size, drawn.scale);
    leave(lists, [&](const Listed& listed) {
        const PixelRange& tile = listed.tile;
        const PixelRange range = planes.range(drawn.center_radius[listed.candidate.index]);
        return range.left + by.left <= tile.right && range.right - by.right >= tile.left && range.top + by.top <= tile.bottom &&
               range.bottom - by.bottom >= tile.top;
    });
}

// With pictures by the filter; the oracle's own are in pictures_test.cpp.
const Proven& some_tile_trials() {
    static const Proven some = [] {
        Proven trials;
        const Trials all = tile_trials();
        for (std::size_t i = 0; i < all.size(); i += 3) trials.trials.push_back(all[i]);
        trials.trials.push_back(crowded_tiles_trial({29, 233}, 10'000, 20));
        for (const Trial& trial : trials.trials) trials.pictures.push_back(filtered_picture(trial.scene, trial.size).numbers);
        return trials;
    }();
    return some;
}

void expect_lists_caught(const std::string& mistake, const Change& change) {
    for (const auto& [whose, costs] : {std::pair("gpu: ", gpu_tile_costs), {"cpu: ", cpu_tile_costs}}) {
        expect_caught(
            whose + mistake, [&, costs = costs](const Trial& trial) { return resolved(trial, costs, change); }, some_tile_trials());
    }
}

void expect_rules_caught(const std::string& mistake, const Rules& rules, const Proven& among = proven_trials()) {
    expect_caught(
        mistake, [&](const Trial& trial) { return picture(trial.scene, trial.size, rules); }, among);
}

// In one test, as those below, because a process of its own for each would make the trials' pictures again.
TEST(Teeth, wrong_definitions_and_pictures_that_are_not_certified) {
    expect_rules_caught("the last of equals", {.first_of_equals = false});
    expect_rules_caught("tangents miss", {.tangent_hits = false});
    expect_rules_caught("a hit at t = 0", {.zero_is_positive = true});
    expect_rules_caught("near root", {.near_root_from_inside = true});
    expect_caught("b^2 - 4ac in float", textbook);
    for (const Backend backend : tested_backends()) {
        OpenBackend open = opened(backend);
        expect_caught("not certified, " + open.description, [&](const Trial& t) { return visible_spheres(open, t, false); });
    }
}

TEST(Teeth, orthographic_mistakes) {
    Trials trials;
    for (std::uint64_t i = 0; i < 60; ++i) {
        trials.push_back(i % 2 == 0 ? orthographic(lattice_trial(seed() + i)) : parallel_near_miss_trial(seed() + i));
    }
    const Proven parallel = proven(std::move(trials));
    expect_rules_caught("parallel rays that begin in the eye", {.origins_in_plane = false}, parallel);
    expect_rules_caught("the root that counts for the eye", {.side_of_eye = true}, parallel);
    expect_rules_caught("parallel rays, tangents miss", {.tangent_hits = false}, parallel);
    expect_rules_caught("parallel rays, a hit at t = 0", {.zero_is_positive = true}, parallel);
}

TEST(Teeth, lists_that_are_wrong_and_lists_that_are_right) {
    // Tiles that miss a pixel at their border.
    expect_lists_caught("a column too few at the left", [](auto& lists, auto& trial) { shrink(lists, trial, {1, 0, 0, 0}); });
    expect_lists_caught("a row too few at the top", [](auto& lists, auto& trial) { shrink(lists, trial, {0, 1, 0, 0}); });
    expect_lists_caught("a column too few at the right", [](auto& lists, auto& trial) { shrink(lists, trial, {0, 0, 1, 0}); });
    expect_lists_caught("a row too few at the bottom", [](auto& lists, auto& trial) { shrink(lists, trial, {0, 0, 0, 1}); });
    // Lists that lack a sphere.
    expect_lists_caught("the last of each list is missing",
                        [](auto& lists, auto&) { leave(lists, [](const Listed& listed) { return listed.after > 0; }); });
    expect_lists_caught("the coarser tiles are missing", [](auto& lists, auto&) {
        if (lists.levels.size() > 1) lists.levels.erase(lists.levels.begin());
    });
    // Walks that end too soon.
    expect_lists_caught("nearer than the lists say", [](auto& lists, auto&) {
        for (Candidate& candidate : lists.candidates) candidate.nearest *= 1.01F;
    });
    expect_lists_caught("lists in the order of the file", [](auto& lists, auto&) {
        for (std::size_t tile = 0; tile + 1 < lists.begins.size(); ++tile) {
            const auto begin = lists.candidates.begin();
            std::sort(begin + lists.begins[tile], begin + lists.begins[tile + 1],
                      [](const Candidate& a, const Candidate& b) { return a.index < b.index; });
        }
    });
    // Right ones are not caught.
    for (const TileCosts& costs : {gpu_tile_costs, cpu_tile_costs}) {
        const auto unchanged = [&](const Trial& trial) {
            return resolved(trial, costs, [](auto& lists, auto& of) { shrink(lists, of, {0, 0, 0, 0}); });
        };
        EXPECT_EQ(caught(some_tile_trials(), unchanged), 0U);
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

// Lists and drawn spheres that followed edits show what those show that are built from nothing.
#include "tiles/live_lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>

#include "edit/document.hpp"
#include "exact/explain.hpp"
#include "exact/resolve.hpp"
#include "support/trials.hpp"
#include "tiles/build_lists.hpp"

namespace sphereview {
namespace {

using Random = std::mt19937_64;

constexpr TileCosts costs = {.smallest_shift = 1, .candidate = 4.0, .test = 1.0};

double between(Random& random, double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }

std::uint32_t below(Random& random, std::size_t count) { return static_cast<std::uint32_t>(random() % count); }

// Mostly in the picture; some beside it, behind the eye, around it, or large.
Sphere random_sphere(Random& random, double radius) {
    Sphere sphere;
    const double z = random() % 20 == 0 ? between(random, -100.0, 100.0) : between(random, 120.0, 500.0);
    sphere.center = {between(random, -0.6, 0.6) * z, between(random, -0.6, 0.6) * z, z};
    sphere.radius = radius * (random() % 50 == 0 ? 40.0 : between(random, 0.3, 2.0));
    sphere.color = {static_cast<std::uint8_t>(random()), 9, 8};
    sphere.hidden = random() % 10 == 0;
    return sphere;
}

Scene random_scene_of(Random& random, std::size_t count) {
    Scene scene;
    const double radius = 80.0 / std::sqrt(static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        scene.spheres.push_back(random() % 40 == 0 && i > 0 ? scene.spheres[below(random, i)] : random_sphere(random, radius));
    }
    return scene;
}

ChangeSpheres random_change(Random& random, const Scene& scene) {
    ChangeSpheres change;
    for (std::size_t n = 1 + random() % 5; n > 0; --n) change.numbers.push_back(below(random, scene.spheres.size()));
    std::ranges::sort(change.numbers);
    change.numbers.erase(std::unique(change.numbers.begin(), change.numbers.end()), change.numbers.end());
    for (const std::uint32_t number : change.numbers) {
        Sphere sphere = scene.spheres[number];
        switch (random() % 6) {
            case 0: sphere.hidden = !sphere.hidden; break;
            case 1: sphere.color.r = static_cast<std::uint8_t>(random()); break;
            case 2: sphere = random_sphere(random, 3.0); break;
            case 3: sphere.radius *= between(random, 0.5, 2.0); break;
            case 4:
                if (random() % 10 == 0) sphere = scene.spheres[below(random, scene.spheres.size())];  // a twin
                break;
            default: sphere.center += glm::dvec3(between(random, -2, 2), between(random, -2, 2), between(random, -2, 2));
        }
        change.spheres.push_back(sphere);
    }
    return change;
}

Edit random_edit_of(Random& random, const Scene& scene) {
    const std::uint64_t kind = random() % 10;
    if (kind < 2) {
        InsertSpheres edit;
        std::uint32_t number = below(random, scene.spheres.size() + 1);
        for (std::size_t n = 1 + random() % 3; n > 0; --n) {
            edit.numbers.push_back(number);
            edit.spheres.push_back({random_sphere(random, 3.0), ""});
            number += random() % 3 == 0 && number + 2 < scene.spheres.size() ? 2 : 1;
        }
        return edit;
    }
    if (kind < 4 && scene.spheres.size() > 10) {
        RemoveSpheres edit;
        for (std::uint32_t number = below(random, scene.spheres.size() - 6); edit.numbers.size() < 1 + random() % 3; ++number) {
            if (random() % 2 == 0) edit.numbers.push_back(number);
            if (number + 1 == scene.spheres.size()) break;
        }
        if (!edit.numbers.empty()) return edit;
    }
    return random_change(random, scene);
}

// In order, nothing twice, nothing that is gone, and after the first free place only free ones.
void expect_lists_whole(const LiveLists& edited) {
    const CandidateLists& lists = edited.lists();
    for (std::size_t tile = 0; tile + 1 < lists.begins.size(); ++tile) {
        for (std::size_t i = lists.begins[tile]; i < lists.begins[tile + 1]; ++i) {
            const Candidate& candidate = lists.candidates[i];
            if (!(candidate == no_candidate)) {
                ASSERT_LT(candidate.index, edited.drawn().size());
                ASSERT_FALSE(std::ranges::binary_search(edited.drawn().gone, candidate.index));
            }
            if (i == lists.begins[tile]) continue;
            ASSERT_LE(lists.candidates[i - 1].nearest, candidate.nearest);
            ASSERT_TRUE(lists.candidates[i - 1].index != candidate.index || candidate == no_candidate);
        }
    }
}

// Of every sphere the index, and of the index the number.
void expect_numbers_right(const DrawnSpheres& drawn, const Scene& scene) {
    for (std::uint32_t number = 0; number < scene.spheres.size(); ++number) {
        const auto index = drawn.index_of(number);
        const bool twin = std::ranges::binary_search(drawn.twins, static_cast<std::int32_t>(number));
        ASSERT_EQ(index.has_value(), !scene.spheres[number].hidden && !twin) << number;
        if (!index) continue;
        ASSERT_EQ(drawn.number(*index), static_cast<std::int32_t>(number));
        if (drawn.beyond_float.contains(static_cast<std::uint32_t>(*index))) continue;
        ASSERT_EQ(drawn.center_radius[*index], *drawn_form(scene.spheres[number], scene.camera, drawn.scale));
    }
}

// What was uploaded, kept up to date by what the scene says has changed.
struct Uploaded {
    std::vector<glm::vec4> spheres;
    std::vector<Candidate> candidates;

    void all(const LiveLists& edited) {
        spheres = edited.drawn().center_radius;
        candidates.assign(edited.lists().candidates.begin(), edited.lists().candidates.end());
    }
    void update(LiveLists& edited) {
        const LiveLists::Changed changed = edited.take_changed();
        spheres.resize(edited.drawn().size());
        ASSERT_TRUE(std::ranges::is_sorted(changed.spheres));
        for (const std::uint32_t index : changed.spheres) spheres[index] = edited.drawn().center_radius[index];
        for (const Places& places : changed.candidates) {
            std::copy_n(edited.lists().candidates.begin() + static_cast<std::ptrdiff_t>(places.first), places.count,
                        candidates.begin() + static_cast<std::ptrdiff_t>(places.first));
        }
    }
    void expect_the_same(const LiveLists& edited) const {
        EXPECT_EQ(spheres, edited.drawn().center_radius);
        EXPECT_TRUE(std::ranges::equal(candidates, edited.lists().candidates));
    }
};

LiveLists built_from(const Scene& scene, const PixelGrid& grid) {
    DrawnSpheres drawn = drawn_spheres(scene);
    CandidateLists lists = build_lists(drawn, scene.camera, grid, costs, EditedLists::spare(grid));
    EditedLists edited(std::move(lists), scene.camera, grid, drawn.scale);
    return {std::move(drawn), std::move(edited), scene.camera};
}

void expect_the_same_hits(const PixelExplanation& expected, const PixelExplanation& found) {
    ASSERT_EQ(found.hits.size(), expected.hits.size());
    ASSERT_EQ(found.farther, 0);
    for (std::size_t i = 0; i < found.hits.size(); ++i) {
        const ExplainedHit& a = expected.hits[i];
        const ExplainedHit& b = found.hits[i];
        ASSERT_EQ(b.number, a.number);
        ASSERT_EQ((std::tuple(b.eye, b.discriminant_sign, b.counts, b.as_near_as_last)),
                  (std::tuple(a.eye, a.discriminant_sign, a.counts, a.as_near_as_last)));
        ASSERT_EQ((std::tuple(b.a, b.b, b.c, b.discriminant, b.t1, b.t2, b.t, b.point, b.normal)),
                  (std::tuple(a.a, a.b, a.c, a.discriminant, a.t1, a.t2, a.t, a.point, a.normal)));
    }
    EXPECT_EQ((std::tuple(found.origin, found.direction, found.hidden)),
              (std::tuple(expected.origin, expected.direction, expected.hidden)));
    EXPECT_EQ(found.missed + found.behind + found.elsewhere, expected.missed + expected.behind);
    EXPECT_LE(found.level, expected.level);
}

class Edited : public testing::TestWithParam<int> {};

TEST_P(Edited, SceneShowsWhatOneThatIsBuiltFromNothingShows) {
    const int step = GetParam();
    const PixelGrid grid{{131, 97}, step};
    int followed = 0;
    int edits = 0;
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test::trials(12)); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const std::size_t count = seed % 3 == 0 ? 3000 : seed % 3 == 1 ? 300 : 20;
        Document document(random_scene_of(random, count));
        const Camera camera = document.scene().camera;
        std::optional<LiveLists> edited;
        Uploaded uploaded;
        std::uint64_t revision = 0;
        const auto build = [&] {
            edited = built_from(document.scene(), grid);
            uploaded.all(*edited);
        };
        build();
        revision = document.revision();
        for (int i = 0; i < 60; ++i) {
            SCOPED_TRACE("edit " + std::to_string(i));
            const std::uint64_t kind = random() % 8;
            if (kind == 0) {
                document.undo();
            } else if (kind == 1) {
                document.redo();
            } else {
                document.apply(random_edit_of(random, document.scene()), "edit");
            }
            if (random() % 4 == 0) continue;  // several at once
            const ChangesSince changes = document.changes_since(revision);
            revision = document.revision();
            if (changes.none()) continue;
            ++edits;
            if (edited->follow(document.scene(), changes)) {
                ++followed;
                uploaded.update(*edited);
            } else {
                build();
            }
            uploaded.expect_the_same(*edited);
            expect_lists_whole(*edited);
            expect_numbers_right(edited->drawn(), document.scene());
            const DrawnSpheres fresh = drawn_spheres(document.scene());
            const Resolver by_all(document.scene(), fresh, grid.picture);
            const Resolver by_lists(document.scene(), edited->drawn(), camera, grid.picture, &edited->lists());
            const PixelRange& covered = edited->lists().covered;
            DecisionLevel level{};
            for (int row = 0; row < grid.size().height; row += 1 + 8 / step) {
                for (int column = static_cast<int>(random() % 3); column < grid.size().width; column += 1 + 4 / step) {
                    const Pixel pixel{grid.traced_column(column), grid.traced_row(row)};
                    const std::int32_t expected = by_all.resolve(pixel, level);
                    ASSERT_EQ(by_lists.resolve(pixel, level), expected) << pixel.x << "," << pixel.y;
                    ASSERT_TRUE(expected < 0 || (pixel.x >= covered.left && pixel.x <= covered.right && pixel.y >= covered.top &&
                                                 pixel.y <= covered.bottom));
                }
            }
            const Pixel pixel{grid.traced_column(static_cast<int>(below(random, static_cast<std::size_t>(grid.size().width)))),
                              grid.traced_row(static_cast<int>(below(random, static_cast<std::size_t>(grid.size().height))))};
            const Scene& scene = document.scene();
            const PixelExplanation by_scene = explain_pixel(scene, drawn_spheres(scene, camera), camera, grid.picture, pixel);
            expect_the_same_hits(by_scene, explain_pixel(scene, edited->drawn(), camera, grid.picture, pixel, &edited->lists()));
            expect_the_same_hits(by_scene, explain_pixel(scene, edited->drawn(), camera, grid.picture, pixel, nullptr));
            const PixelExplanation nearest = explain_pixel(scene, edited->drawn(), camera, grid.picture, pixel, nullptr, 1);
            ASSERT_EQ(nearest.hits.size(), std::min<std::size_t>(by_scene.hits.size(), 1));
            ASSERT_EQ(nearest.farther, static_cast<std::int64_t>(by_scene.hits.size() - nearest.hits.size()));
            ASSERT_EQ(nearest.visible(), by_scene.visible());
            const Resolver by_drawn(scene, edited->drawn(), camera, grid.picture, nullptr);
            ASSERT_EQ(by_drawn.resolve(pixel, level), by_scene.visible()) << pixel.x << "," << pixel.y;
        }
    }
    EXPECT_GT(followed, edits / 2);
    EXPECT_LT(followed, edits);
}

TEST(LiveLists, SaysWhenATileHasNoRoom) {
    Random random(3);
    const PixelGrid grid{{100, 100}, 1};
    Scene scene;
    for (int i = 0; i < 500; ++i) scene.spheres.push_back(random_sphere(random, 3.0));
    Document document(std::move(scene));
    for (const int together : {EditedLists::room_in_tile, EditedLists::room_in_tile + 1}) {
        LiveLists edited = built_from(document.scene(), grid);
        const std::uint64_t revision = document.revision();
        ChangeSpheres change;
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(together); ++i) {
            change.numbers.push_back(i);
            change.spheres.push_back({{0.01 * i, 0.02 * together, 300.0}, 2.0, {}, false});
        }
        document.apply(change, "gather");
        EXPECT_EQ(edited.follow(document.scene(), document.changes_since(revision)), together == EditedLists::room_in_tile);
    }
}

// Both would be tried, and every pixel of them be in doubt.
TEST(LiveLists, LeavesToBuildingWhatEqualsAnother) {
    Random random(6);
    const PixelGrid grid{{100, 100}, 1};
    Scene scene;
    for (int i = 0; i < 300; ++i) scene.spheres.push_back(random_sphere(random, 3.0));
    scene.spheres[7] = {{1, 2, 300}, 5.0, {}, false};
    Document document(std::move(scene));
    LiveLists edited = built_from(document.scene(), grid);
    const std::uint64_t revision = document.revision();
    const Sphere nearly = {{1, 2, std::nextafter(300.0, 301.0)}, 5.0, {}, false};
    document.apply(ChangeSpheres{{3}, {nearly}}, "move");
    EXPECT_TRUE(edited.follow(document.scene(), document.changes_since(revision)));
    const std::uint64_t moved = document.revision();
    document.apply(ChangeSpheres{{3}, {document.scene().spheres[7]}}, "move");
    EXPECT_FALSE(edited.follow(document.scene(), document.changes_since(moved)));
    const std::uint64_t equal = document.revision();
    document.apply(ChangeSpheres{{5}, {nearly}}, "move");
    EXPECT_FALSE(edited.follow(document.scene(), document.changes_since(equal)));  // of no use any more
}

TEST(LiveLists, LeavesToBuildingWhatIsMuch) {
    Random random(4);
    const PixelGrid grid{{400, 400}, 1};
    Document document(random_scene_of(random, 2 * LiveLists::most_changes));
    LiveLists edited = built_from(document.scene(), grid);
    const std::uint64_t revision = document.revision();
    ChangeSpheres change;
    for (std::uint32_t i = 0; i <= LiveLists::most_changes; ++i) {
        change.numbers.push_back(i);
        change.spheres.push_back(random_sphere(random, 0.1));
    }
    document.apply(change, "many");
    EXPECT_FALSE(edited.follow(document.scene(), document.changes_since(revision)));
    EXPECT_TRUE(edited.edited());
}

// In a million spheres, by some thousands of edits one after the other; the lists are those of all spheres.
TEST(LiveLists, OfAMillionSpheresFollowsManyEdits) {
    Random random(5);
    const PixelGrid grid{{1000, 1000}, 1};
    Scene scene;
    constexpr int count = test::is_sanitized ? 100'000 : 1'000'000;
    for (int i = 0; i < count; ++i) scene.spheres.push_back(random_sphere(random, 0.3));
    const Camera camera = scene.camera;
    Document document(std::move(scene));
    LiveLists edited = built_from(document.scene(), grid);
    std::uint64_t revision = document.revision();
    int followed = 0;
    for (int i = 0; i < 300; ++i) {
        if (i % 5 == 3) {
            document.undo();
        } else if (i % 5 == 4) {
            document.redo();
        } else if (i % 50 == 0) {
            document.apply(random_edit_of(random, document.scene()), "edit");  // perhaps insertions and removals
        } else {
            document.apply(random_change(random, document.scene()), "change");
        }
        const ChangesSince changes = document.changes_since(revision);
        revision = document.revision();
        if (edited.follow(document.scene(), changes)) {
            ++followed;
        } else {
            edited = built_from(document.scene(), grid);
        }
    }
    EXPECT_GT(followed, 250);
    expect_lists_whole(edited);
    expect_numbers_right(edited.drawn(), document.scene());
    const LiveLists fresh = built_from(document.scene(), grid);
    const Resolver by_fresh(document.scene(), fresh.drawn(), camera, grid.picture, &fresh.lists());
    const Resolver by_edited(document.scene(), edited.drawn(), camera, grid.picture, &edited.lists());
    DecisionLevel level{};
    for (int y = 0; y < 1000; y += 7) {
        for (int x = y % 5; x < 1000; x += 11) ASSERT_EQ(by_edited.resolve({x, y}, level), by_fresh.resolve({x, y}, level));
    }
}

INSTANTIATE_TEST_SUITE_P(Steps, Edited, testing::Values(1, 4));

}  // namespace
}  // namespace sphereview

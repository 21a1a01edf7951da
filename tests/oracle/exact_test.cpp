// The parts of src/exact on their own, against the oracle.
#include <gtest/gtest.h>

#include "exact/exact_decision.hpp"
#include "exact/exact_quadratic.hpp"
#include "exact/resolve.hpp"
#include "oracle/oracle.hpp"
#include "oracle/scenes.hpp"
#include "support/decide_exactly.hpp"
#include "support/spheres.hpp"

namespace sphereview::oracle {

namespace {

int as_sign(EyeSide side) { return side == EyeSide::outside ? 1 : side == EyeSide::inside ? -1 : 0; }

Trials degenerate_trials() {
    Trials trials;
    for (std::uint64_t i = 1000; i < 1400; ++i) {
        if (!is_sampled(i)) continue;
        trials.push_back(bit_pattern_trial(i));
        trials.push_back(lattice_trial(i));
    }
    const Trials all = touching_trials();
    for (std::size_t i = 0; i < all.size(); i += 10) trials.push_back(all[i]);
    return trials;
}

// As exact/explain.cpp has it.
int discriminant_sign_of(const Camera& camera, PictureSize size, Pixel at, const Sphere& sphere) {
    CommonScale scale;
    scale.include(camera);
    scale.include(sphere);
    const IntegerVector ray = exact_direction(camera, size, at, scale);
    return ExactQuadratic(sphere, exact_origin(camera, size, at, scale), ray, dot(ray, ray), scale).d.sign();
}

TEST(EyeSide, is_the_oracles) {
    int on_surfaces = 0;
    for (const Trial& trial : degenerate_trials()) {
        for (const Sphere& sphere : trial.scene.spheres) {
            const EyeSide side = sphereview::eye_side(sphere, trial.scene.camera.eye);
            ASSERT_EQ(as_sign(side), oracle::eye_side(sphere, trial.scene.camera.eye)) << trial.name;
            on_surfaces += side == EyeSide::on_surface ? 1 : 0;
        }
    }
    EXPECT_GT(on_surfaces, 10);
}

TEST(EyeSide, is_the_oracles_for_a_plane) {
    int in_plane = 0;
    for (const Trial& trial : degenerate_trials()) {
        const Camera camera = orthographic(trial).scene.camera;
        const EyeSides sides(camera);
        for (const Sphere& sphere : trial.scene.spheres) {
            const EyeSide side = sides(sphere);
            ASSERT_EQ(side, oracle::eye_is_outside(sphere, camera) ? EyeSide::outside : EyeSide::in_plane) << trial.name;
            in_plane += side == EyeSide::in_plane ? 1 : 0;
        }
    }
    EXPECT_GT(in_plane, 10);
}

TEST(ExactDecision, is_the_oracles) {
    int ties = 0;
    int tangents = 0;
    for (const Trial& trial : degenerate_trials()) {
        const Camera& camera = trial.scene.camera;
        Random random(seed() + static_cast<std::uint64_t>(trial.size.width));
        std::vector<Contender> contenders;
        for (std::size_t i = 0; i < trial.scene.spheres.size(); ++i) {
            contenders.push_back({static_cast<std::int32_t>(i), &trial.scene.spheres[i]});
        }
        for (int i = 0; i < 12; ++i) {
            // The middle is where most happens.
            const Pixel at = i == 0 ? Pixel{trial.size.width / 2, trial.size.height / 2}
                                    : Pixel{random.whole(0, trial.size.width - 1), random.whole(0, trial.size.height - 1)};
            const std::int32_t expected = pixel(trial.scene, trial.size, at);
            ASSERT_EQ(decide_exactly(camera, trial.size, at, contenders), expected) << trial.name << ", " << at.x << "," << at.y;
            // The order of the list does not matter, only the numbers.
            std::vector<Contender> reversed(contenders.rbegin(), contenders.rend());
            ASSERT_EQ(decide_exactly(camera, trial.size, at, reversed), expected) << trial.name << ", " << at.x << "," << at.y;
            if (contenders.empty()) continue;
            const Sphere& any = trial.scene.spheres[random.bits() % contenders.size()];
            const int sign = oracle::discriminant_sign(camera, trial.size, at, any);
            ASSERT_EQ(discriminant_sign_of(camera, trial.size, at, any), sign) << trial.name;
            tangents += sign == 0 ? 1 : 0;
            if (expected < 0) continue;
            Scene without = trial.scene;
            without.spheres[static_cast<std::size_t>(expected)].hidden = true;
            const std::int32_t next = pixel(without, trial.size, at);
            if (next < 0) continue;
            // A tie: with the numbers swapped the other one wins.
            std::vector<Contender> pair = {{1, contenders[static_cast<std::size_t>(expected)].sphere},
                                           {0, contenders[static_cast<std::size_t>(next)].sphere}};
            ties += decide_exactly(camera, trial.size, at, pair) == 0 ? 1 : 0;
        }
    }
    EXPECT_GT(ties, 10);
    EXPECT_GT(tangents, 10);
}

TEST(DrawnSpheres, leave_out_copies_and_hidden_spheres) {
    Scene scene = scene_of({{{0, 0, 200}, 20, {1, 2, 3}, true},  // hidden: no other is its copy
                            {{-0.0, 0, 200}, 20, {4, 5, 6}},
                            {{0.0, -0.0, 200}, 20, {7, 8, 9}},
                            {{0, 0, 200.00000000000003}, 20, {}},
                            {{0, 0, 200}, 20.000000000000004, {}},
                            {{0, 0, 200}, 20, {}}});
    const DrawnSpheres drawn = drawn_spheres(scene);
    EXPECT_EQ(drawn.numbers, (std::vector<std::int32_t>{1, 3, 4}));
    EXPECT_EQ(drawn.size(), 3U);
    EXPECT_EQ(picture(scene, {1, 1}).front(), 4);
}

TEST(DrawnSpheres, stay_finite_whatever_the_numbers) {
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const Trial trial = bit_pattern_trial(i);
        const DrawnSpheres drawn = drawn_spheres(trial.scene);
        for (std::size_t k = 0; k < drawn.size(); ++k) {
            for (int component = 0; component < 4; ++component) {
                ASSERT_LE(std::fabs(drawn.center_radius[k][component]), 0x1p60F) << trial.name;
            }
            const Sphere& sphere = trial.scene.spheres[static_cast<std::size_t>(drawn.number(k))];
            ASSERT_EQ(as_sign(drawn.side(k)), oracle::eye_side(sphere, trial.scene.camera.eye)) << trial.name;
        }
        for (const double unit : {float_unit, gpu_unit}) {
            const FloatView view = float_view(trial.scene.camera, trial.size, drawn.scale, unit);
            ASSERT_TRUE(std::isfinite(view.error_scale)) << trial.name;
            for (const glm::vec3& v : {view.rays.forward, view.rays.right, view.rays.up}) {
                ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)) << trial.name;
            }
        }
    }
}

// Also when a renderer finds everything doubtful, the resolver alone has the right picture, and it counts all pixels.
TEST(Resolver, decides_what_is_doubtful_and_counts_it) {
    Trials trials = degenerate_trials();
    for (std::size_t i = trials.size(); i-- > 0;) trials.push_back(orthographic(trials[i]));
    for (const Trial& trial : trials) {
        const DrawnSpheres drawn = drawn_spheres(trial.scene);
        const Resolver resolver(trial.scene, drawn, trial.size);
        std::vector<std::int32_t> visible(static_cast<std::size_t>(trial.size.width * trial.size.height), doubtful_background);
        const DecisionCounts counts = resolver.certify({0, 0, trial.size.width, trial.size.height}, visible);
        ASSERT_EQ(visible, picture(trial.scene, trial.size)) << trial.name;
        EXPECT_EQ(counts.in_float, 0);
        EXPECT_EQ(counts.in_double + counts.exactly, trial.size.width * trial.size.height);
    }
}

TEST(Resolver, leaves_decided_pixels_alone) {
    Scene scene = scene_of({{{0, 0, 200}, 20, {}, true}, {{0, 0, 300}, 20}, {{0, 0, 200}, 20}});
    const DrawnSpheres drawn = drawn_spheres(scene);
    const Resolver resolver(scene, drawn, {3, 1});
    std::vector<std::int32_t> visible = {visible_background, 0, doubtful(0)};  // the middle is wrong, but decided
    const DecisionCounts counts = resolver.certify({0, 0, 3, 1}, visible);
    EXPECT_EQ(visible, (std::vector<std::int32_t>{-1, 1, -1}));
    EXPECT_EQ(counts.in_float, 2);
    EXPECT_EQ(counts.in_double, 1);
    visible = {doubtful(visible_background), doubtful(1), 0};
    resolver.accept_guesses(visible);
    EXPECT_EQ(visible, (std::vector<std::int32_t>{-1, 2, 1}));
    DecisionLevel level = DecisionLevel::in_float;
    EXPECT_EQ(resolver.resolve({1, 0}, level), 2);
    EXPECT_EQ(level, DecisionLevel::in_double);
}

TEST(Resolver, says_what_only_whole_numbers_decide) {
    Scene scene = scene_of({{{20, 0, 200}, 20}, {{0, 20, 200}, 20}});  // both touch the axis at 200
    const DrawnSpheres drawn = drawn_spheres(scene);
    DecisionLevel level = DecisionLevel::in_float;
    EXPECT_EQ(Resolver(scene, drawn, {1, 1}).resolve({0, 0}, level), 0);
    EXPECT_EQ(level, DecisionLevel::exactly);
}

TEST(Doubtful, is_its_own_inverse_for_all_numbers) {
    for (const std::int32_t guess : {-1, 0, 1, 1023, 1999999999}) {
        EXPECT_TRUE(is_doubtful(doubtful(guess)));
        EXPECT_FALSE(is_doubtful(guess));
        EXPECT_EQ(doubtful(doubtful(guess)), guess);
    }
}

}  // namespace

}  // namespace sphereview::oracle

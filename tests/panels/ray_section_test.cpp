#include "panels/ray_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "unit/projection.hpp"

namespace sphereview {

namespace {

constexpr PictureSize square{101, 101};

struct SectionOfPixel {
    SectionOfPixel(std::vector<Sphere> spheres, Pixel at, const Camera& camera = {}) : pixel(at) {
        scene.spheres = std::move(spheres);
        scene.camera = camera;
        explanation = explain_pixel(scene, drawn_spheres(scene), scene.camera, square, pixel, nullptr, most_hits_explained,
                                    most_passed_explained);
    }
    RaySection section(std::optional<std::int32_t> subject = {}, std::optional<glm::dvec3> sun = {},
                       std::optional<std::int32_t> blocker = {}) const {
        return section_of({scene, scene.camera, square, pixel, explanation, sun, blocker}, subject, 2.0);
    }

    Scene scene;
    Pixel pixel;
    PixelExplanation explanation;
};

const SectionCircle& circle(const RaySection& section, std::int32_t number) {
    const auto found = std::ranges::find(section.circles, number, &SectionCircle::number);
    EXPECT_NE(found, section.circles.end());
    return *found;
}

const Camera oblique{{3.0, 4.0, -5.0}, {10.0, 14.0, 95.0}, {50.0, 0.0, 0.0}, {0.0, 50.0, 0.0}};

TEST(RaySectionTest, HasTheRootsOnTheCircles) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        Camera camera = oblique;
        camera.projection = projection;
        const SectionOfPixel of({{{30.0, 30.0, 200.0}, 35.0}, {{20.0, 40.0, 330.0}, 50.0}, {{5.0, 20.0, -60.0}, 40.0}}, {60, 40},
                                camera);
        ASSERT_GE(of.explanation.hits.size(), 1U);
        const RaySection section = of.section();
        int roots = 0;
        for (const SectionCircle& one : section.circles) {
            if (!one.met) continue;
            EXPECT_TRUE(one.cut);
            for (const double x : {one.first, one.second}) {
                EXPECT_NEAR(glm::distance(glm::dvec2(x, 0.0), one.center), one.radius, 1e-9 * one.radius);
                ++roots;
            }
        }
        EXPECT_GE(roots, 2);
        // The plane goes through the centre of what is seen.
        EXPECT_NEAR(section.circles.front().radius,
                    of.scene.spheres[static_cast<std::size_t>(section.circles.front().number)].radius, 1e-9);
        EXPECT_DOUBLE_EQ(*section.seen, of.explanation.hits.front().t * glm::length(of.explanation.direction));
    }
}

TEST(RaySectionTest, IsTheSameForAScreenOfAnySize) {
    const std::vector<Sphere> spheres = {{{0.0, 0.0, 200.0}, 20.0}, {{10.0, 5.0, 300.0}, 40.0}};
    const RaySection usual = SectionOfPixel(spheres, {52, 49}).section();
    ASSERT_EQ(usual.circles.size(), 2U);
    for (const int exponent : exponents_of_screens) {
        const RaySection section = SectionOfPixel(spheres, {52, 49}, camera_of_screen(exponent)).section();
        ASSERT_EQ(section.circles.size(), 2U) << exponent;
        EXPECT_NEAR(*section.seen, *usual.seen, 1e-9) << exponent;
        ASSERT_TRUE(section.screen) << exponent;
        for (int axis = 0; axis < 2; ++axis)
            EXPECT_NEAR(std::ldexp(section.screen->to[axis], -exponent), usual.screen->to[axis], 1e-9) << exponent;
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_NEAR(section.circles[i].first, usual.circles[i].first, 1e-9) << exponent;
            EXPECT_NEAR(section.circles[i].second, usual.circles[i].second, 1e-9) << exponent;
        }
    }
}

TEST(RaySectionTest, CountsOneRootOfEachHit) {
    const SectionOfPixel of({{{0.0, 0.0, 200.0}, 20.0}, {{0.0, 0.0, 0.0}, 30.0}, {{0.0, 0.0, -200.0}, 20.0}}, {50, 50});
    const RaySection section = of.section();
    EXPECT_EQ(section.circles.front().number, 1);
    EXPECT_TRUE(circle(section, 0).first_counts && !circle(section, 0).second_counts);
    EXPECT_TRUE(!circle(section, 1).first_counts && circle(section, 1).second_counts);
    const SectionCircle& behind = circle(section, 2);
    EXPECT_TRUE(behind.met && !behind.first_counts && !behind.second_counts);
    EXPECT_DOUBLE_EQ(behind.first, -220.0);
    EXPECT_DOUBLE_EQ(behind.second, -180.0);
    EXPECT_EQ(of.section(0).circles.front().number, 0);
    EXPECT_EQ(of.section(7).circles.front().number, 1) << "a sphere that is not there is no subject";
}

TEST(RaySectionTest, HasRoomForWhatTheRayMisses) {
    // Beside the plane of the first, and above the ray.
    const SectionOfPixel of({{{0.0, 10.0, 200.0}, 20.0}, {{60.0, 0.0, 210.0}, 20.0}, {{0.0, 45.0, 260.0}, 20.0}}, {50, 50});
    const RaySection section = of.section();
    EXPECT_FALSE(circle(section, 1).cut);
    EXPECT_FALSE(circle(section, 1).met);
    EXPECT_TRUE(circle(section, 2).cut);
    EXPECT_NEAR(circle(section, 2).center.y, 45.0, 1e-9) << "up is up";
    EXPECT_TRUE(section.outside.empty());
    EXPECT_FALSE(section.eye_outside);
    EXPECT_FALSE(section.screen_outside);
    const RaySection missed = of.section(2);
    EXPECT_EQ(missed.circles.front().number, 2);
    EXPECT_NEAR(missed.circles.front().radius, 20.0, 1e-9);
}

TEST(RaySectionTest, KeepsTinyAndHugeSpheresReadable) {
    const auto part = [](const RaySection& section, double length) {
        return length / (section.window.high.x - section.window.low.x);
    };
    const RaySection far = SectionOfPixel({{{0.0, 0.0, 1e6}, 1.0}, {{0.0, 0.0, 2e6}, 5.0}}, {50, 50}).section();
    EXPECT_GT(part(far, 2.0), 0.05);
    EXPECT_TRUE(far.eye_outside);
    EXPECT_TRUE(far.screen_outside);
    EXPECT_EQ(far.outside, std::vector<std::int32_t>{1});
    const RaySection ground = SectionOfPixel({{{0.0, -1e6 - 20.0, 0.0}, 1e6}}, {50, 80}).section();
    ASSERT_TRUE(ground.seen);
    EXPECT_GT(part(ground, *ground.seen), 0.2);
    EXPECT_FALSE(ground.eye_outside);
    EXPECT_TRUE(ground.outside.empty());
    for (const double size : {1e-200, 1e200}) {
        const RaySection odd = SectionOfPixel({{{0.0, 0.0, 4.0 * size}, size}}, {50, 50}).section();
        EXPECT_TRUE(std::isfinite(odd.window.low.x) && std::isfinite(odd.window.high.y)) << size;
        EXPECT_LT(odd.window.low.x, odd.window.high.x) << size;
    }
}

TEST(RaySectionTest, ShowsTheScreenAsLargeAsItIs) {
    const RaySection section = SectionOfPixel({}, {50, 20}).section();
    ASSERT_TRUE(section.screen);
    EXPECT_FALSE(section.eye_plane);
    EXPECT_NEAR(glm::distance(section.screen->from, section.screen->to), 100.0, 1e-9);
    for (const glm::dvec2& edge : {section.screen->from, section.screen->to}) {
        EXPECT_NEAR(glm::length(edge), std::hypot(100.0, 50.0), 1e-9) << "upright";
    }
    EXPECT_TRUE(section.window.holds({0.0, 0.0}));
    Camera parallel;
    parallel.projection = Projection::orthographic;
    const RaySection beside = SectionOfPixel({}, {50, 20}, parallel).section();
    ASSERT_TRUE(beside.eye_plane);
    EXPECT_NEAR(beside.eye_plane->from.x, 0.0, 1e-9);
    EXPECT_NEAR(beside.screen->from.x, 100.0, 1e-9);
}

TEST(RaySectionTest, FollowsTheShadowRayToWhatIsInTheWay) {
    const SectionOfPixel of({{{0.0, 0.0, 200.0}, 20.0}, {{0.0, 100.0, 180.0}, 10.0}}, {50, 50});
    const glm::dvec3 up{0.0, 2.0, 0.0};
    const RaySection blocked = of.section({}, up, 1);
    ASSERT_TRUE(blocked.to_sun);
    EXPECT_NEAR(blocked.to_sun->from.x, 180.0, 1e-9);
    EXPECT_NEAR(blocked.to_sun->from.y, 0.0, 1e-9);
    EXPECT_NEAR(blocked.to_sun->to.y, 90.0, 1e-9);
    EXPECT_TRUE(blocked.outside.empty());
    EXPECT_GT(of.section({}, up).to_sun->to.y, 150.0) << "beyond what the drawing shows";
    EXPECT_FALSE(of.section().to_sun);
}

TEST(RaySectionTest, HasADrawingOfTheShadowRayItself) {
    const SectionOfPixel of({{{0.0, 0.0, 200.0}, 20.0}, {{0.0, 60.0, 120.0}, 10.0}}, {50, 50});
    const glm::dvec3 sun{0.0, 3.0, -3.0};
    const auto shadow = shadow_ray(of.scene, of.explanation, sun, 1);
    ASSERT_TRUE(shadow);
    EXPECT_EQ(shadow->visible(), 1);
    const RaySection section = section_of({of.scene, of.scene.camera, square, of.pixel, *shadow, {}, {}, false}, {}, 2.0);
    EXPECT_FALSE(section.screen);
    EXPECT_EQ(section.circles.front().number, 1);
    EXPECT_NEAR(circle(section, 1).first, std::sqrt(2.0) * 60.0 - 10.0, 1e-9);
    EXPECT_NEAR(circle(section, 0).second, 0.0, 1e-9) << "the point is on its sphere";
    EXPECT_LT(circle(section, 0).first, 0.0);
    EXPECT_TRUE(section.outside.empty());
    EXPECT_TRUE(shadow_ray(of.scene, of.explanation, sun, {})->hits.empty());
    EXPECT_FALSE(shadow_ray(of.scene, PixelExplanation{}, sun, {}));
}

TEST(RaySectionTest, HasPointsWhereTheWindowIs) {
    const SectionWindow window{{0.0, -1.0}, {2.0, 1.0}};
    for (const double radius : {1.0, 1e3, 1e7}) {
        const SectionCircle one{.center = {1.0 + radius, 0.0}, .radius = radius};
        const std::vector<glm::dvec2> points = points_of(one, window);
        const auto inside = std::ranges::count_if(points, [&](const glm::dvec2& point) { return window.holds(point); });
        EXPECT_GE(inside, 12) << radius;
    }
}

TEST(QuadraticPlotTest, ShowsTheDiscriminant) {
    const SectionOfPixel of({{{0.0, 0.0, 200.0}, 20.0}, {{30.0, 0.0, 300.0}, 20.0}, {{0.0, 0.0, -200.0}, 20.0}}, {50, 50});
    const QuadraticPlot plot = plot_of(of.explanation, 0);
    ASSERT_EQ(plot.curves.size(), 3U);
    const QuadraticCurve& hit = plot.curves.front();
    EXPECT_EQ(hit.number, 0);
    EXPECT_DOUBLE_EQ(hit.lowest_t, 2.0);
    EXPECT_NEAR(hit.lowest, -0.04, 1e-12);  // -discriminant / (4 a^2) = -1.6e7 / 4e8
    EXPECT_NEAR(hit.at(hit.t1), 0.0, 1e-12);
    EXPECT_NEAR(hit.at(hit.t2), 0.0, 1e-12);
    EXPECT_TRUE(hit.first_counts);
    EXPECT_LT(plot.left, hit.t1);
    EXPECT_GT(plot.right, hit.t2);
    EXPECT_LT(plot.bottom, hit.lowest);
    EXPECT_GT(plot.top, 0.0);

    const QuadraticPlot missed = plot_of(of.explanation, 1);
    EXPECT_EQ(missed.curves.front().number, 1);
    EXPECT_EQ(missed.curves.front().sign, -1);
    EXPECT_NEAR(missed.curves.front().lowest, 0.05, 1e-12);
    EXPECT_GT(missed.top, missed.curves.front().lowest);
    EXPECT_LT(missed.bottom, 0.0);
    const QuadraticPlot behind = plot_of(of.explanation, 2);
    EXPECT_FALSE(behind.curves.front().first_counts || behind.curves.front().second_counts);
    EXPECT_LT(behind.left, -2.2);
    EXPECT_TRUE(plot_of(PixelExplanation{}, 0).curves.empty());

    const QuadraticPlot tangent = plot_of(SectionOfPixel({{{20.0, 0.0, 200.0}, 20.0}}, {50, 50}).explanation, 0);
    EXPECT_EQ(tangent.curves.front().lowest, 0.0);
    EXPECT_LT(tangent.left, 2.0);
    EXPECT_GT(tangent.right, 2.0);
    EXPECT_LT(tangent.bottom, tangent.top);
}

}  // namespace

}  // namespace sphereview

#include "camera/fit.hpp"
#include "camera/navigation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "oracle/random.hpp"
#include "support/spheres.hpp"

namespace sphereview {

void PrintTo(const Camera& camera, std::ostream* out);

namespace {

using oracle::Random;

ViewAxes view(const std::string& text) { return parse_view(text).value(); }

long double dot(const glm::dvec3& a, const glm::dvec3& b) {
    return static_cast<long double>(a.x) * b.x + static_cast<long double>(a.y) * b.y + static_cast<long double>(a.z) * b.z;
}

// The greatest slope x / z of a circle's tangents through the origin; infinite if it is not before that.
long double greatest_slope(long double x, long double z, long double radius) {
    const long double far = std::hypot(x, z);
    if (!(far > radius)) return std::numeric_limits<long double>::infinity();
    const long double angle = std::atan2(x, z) + std::asin(radius / far);
    return angle < std::acos(0.0L) ? std::tan(angle) : std::numeric_limits<long double>::infinity();
}

// How near the spheres come to the screen's right, left, upper and lower edge, in parts of the way from the middle to the edge:
// below 1 is inside. Of an eye before them, by the tangent lines in the plane of two axes, in long double, relative to the eye.
using Reach = std::array<double, 4>;

Reach reach_of(const Camera& camera, const ViewAxes& axes, const Scene& scene) {
    Reach all{};
    for (const Sphere& sphere : scene.spheres) {
        if (sphere.hidden) continue;
        const glm::dvec3 place = sphere.center - camera.eye;
        const long double x = dot(place, axes.right);
        const long double y = dot(place, axes.up);
        const long double towards[] = {x, -x, y, -y};
        for (std::size_t i = 0; i < 4; ++i) {
            const long double slope = greatest_slope(towards[i], dot(place, axes.ahead), sphere.radius);
            all[i] = std::max(all[i], static_cast<double>(2.0L * slope));
        }
    }
    return all;
}

// Everything within the margin, and two opposite sides of that touched; the same on either side of the other axis.
void expect_tight(const Scene& scene, const ViewAxes& axes) {
    constexpr double margin = 31.0 / 32.0;
    constexpr double tolerance = 1e-9;
    const std::optional<Camera> camera = fitted(scene, axes);
    ASSERT_TRUE(camera);
    ASSERT_FALSE(camera_fault(*camera)) << camera_fault(*camera)->what;
    const Reach reach = reach_of(*camera, axes, scene);
    EXPECT_LE(std::ranges::max(reach), margin + tolerance);
    const auto touched = [&](std::size_t side) { return std::fabs(reach[side] - margin) < tolerance; };
    EXPECT_TRUE((touched(0) && touched(1)) || (touched(2) && touched(3))) << testing::PrintToString(reach);
}

// Whatever doubles can hold of it: inside the picture, with a camera that has no fault.
void expect_inside(const Scene& scene, const ViewAxes& axes) {
    const std::optional<Camera> camera = fitted(scene, axes);
    ASSERT_TRUE(camera);
    ASSERT_FALSE(camera_fault(*camera)) << camera_fault(*camera)->what;
    EXPECT_LE(std::ranges::max(reach_of(*camera, axes_of(*camera), scene)), 1.0);
}

void expect_axes(const ViewAxes& found, const ViewAxes& expected, double tolerance = 0.0) {
    EXPECT_LE(glm::distance(found.right, expected.right), tolerance);
    EXPECT_LE(glm::distance(found.up, expected.up), tolerance);
    EXPECT_LE(glm::distance(found.ahead, expected.ahead), tolerance);
}

const std::vector<std::string> views = {"front", "back", "left", "right", "top", "bottom", "iso", "30,-20", "200.5,77", "-91,-90"};

}  // namespace

TEST(ViewAxes, KeepToTheHandOfThePresentOnes) {
    const ViewAxes front;
    expect_axes(with_hand_of(front, view("right")), view("right"));
    expect_axes(with_hand_of(data_axes, data_axes), data_axes);
    expect_axes(with_hand_of(data_axes, front), data_axes);
    expect_axes(with_hand_of(front, data_axes), front);
    for (const char* name : {"right", "top", "iso", "20,30"}) {
        const ViewAxes of_data = with_hand_of(data_axes, view(name));
        EXPECT_LT(glm::dot(glm::cross(of_data.right, of_data.up), of_data.ahead), -0.999) << name;
    }
}

// Inside the margin, two opposite sides touched, and nothing in the plane of the eye, also from elsewhere.
TEST(Fit, AnOrthographicScreenIsAsLargeAsWhatItShows) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        Random random(9000 + seed);
        const double scale = random.of_size(1e-6, 1e6);
        Scene scene;
        for (int count = random.whole(1, 12); count > 0; --count) {
            scene.spheres.push_back({scale * random.in_cube(5.0), scale * random.of_size(0.01, 3.0)});
        }
        const ViewAxes axes = view(views[seed % views.size()]);
        const Camera camera = *fitted(scene, axes, Projection::orthographic);
        ASSERT_FALSE(camera_fault(camera));
        EXPECT_EQ(camera.projection, Projection::orthographic);
        Reach reach{};
        for (const Sphere& sphere : scene.spheres) {
            const glm::dvec3 place = sphere.center - camera.eye;
            const double x = glm::dot(place, axes.right);
            const double y = glm::dot(place, axes.up);
            const double towards[] = {x, -x, y, -y};
            const double half = glm::length(camera.right);
            for (std::size_t i = 0; i < 4; ++i) reach[i] = std::max(reach[i], (towards[i] + sphere.radius) / half);
        }
        const auto touched = [&](std::size_t side) { return std::fabs(reach[side] - 31.0 / 32.0) < 1e-9; };
        EXPECT_LE(std::ranges::max(reach), 31.0 / 32.0 + 1e-9);
        EXPECT_TRUE((touched(0) && touched(1)) || (touched(2) && touched(3))) << testing::PrintToString(reach);
        const glm::dvec3 pivot = bounds_of(scene).middle();
        for (const double turn : {0.0, 1.0, 2.0, 3.0}) {
            const Camera turned = orbited(camera, pivot, turn, 0.3 * turn);
            const glm::dvec3 ahead = glm::normalize(turned.center - turned.eye);
            for (const Sphere& sphere : scene.spheres) {
                EXPECT_GT(glm::dot(sphere.center - turned.eye, ahead), sphere.radius);
            }
        }
    }
}

TEST(Fit, EverythingIsInsideAndTouchesTheMargin) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random(7000 + seed);
        Scene scene;
        const double size = std::exp(random.between(-20.0, 20.0));
        const glm::dvec3 origin = random.in_cube(size * std::exp(random.between(-5.0, 5.0)));
        const glm::dvec3 shape = {random.between(0.0, 1.0), random.between(0.0, 1.0), random.between(0.0, 1.0)};
        const int count = 1 + static_cast<int>(seed % 40);
        for (int i = 0; i < count; ++i) {
            Sphere sphere;
            sphere.center = origin + shape * random.in_cube(size);
            sphere.radius = size * std::exp(random.between(-8.0, 0.5));
            sphere.hidden = i > 0 && i % 5 == 0;
            if (sphere.hidden) sphere.center *= 100.0;
            scene.spheres.push_back(sphere);
        }
        expect_tight(scene, axes_from(random.between(-400.0, 400.0), random.between(-90.0, 90.0)));
        expect_tight(scene, view(views[seed % views.size()]));
    }
}

TEST(Fit, ASphereIsInTheMiddle) {
    for (const std::string& name : views) {
        SCOPED_TRACE(name);
        const Scene scene = scene_of({{{0.0, 0.0, 0.0}, 16.0, {}, false}});
        const ViewAxes axes = view(name);
        expect_tight(scene, axes);
        const glm::dvec3 eye = fitted(scene, axes)->eye;
        EXPECT_NEAR(glm::dot(eye, axes.right), 0.0, 1e-13);
        EXPECT_NEAR(glm::dot(eye, axes.up), 0.0, 1e-13);
        EXPECT_LT(glm::dot(eye, axes.ahead), -32.0);
    }
}

TEST(Fit, NothingToSeeHasNoCamera) {
    EXPECT_FALSE(fitted({}, {}));
    EXPECT_FALSE(fitted(scene_of({{{0.0, 0.0, 200.0}, 20.0, {}, true}}), {}));
}

TEST(Fit, HoldsAtTheEndsOfDoubles) {
    constexpr double most = std::numeric_limits<double>::max();
    constexpr double smallest = std::numeric_limits<double>::denorm_min();
    const std::vector<Scene> scenes = {
        scene_of({{{1e15, -1e15, 1e15}, 1.0, {}, false}}),
        scene_of({{{1e15, -1e15, 1e15}, 1e-30, {}, false}}),
        scene_of({{{1e6, 1e6, -1e6}, 2e-8, {}, false}}),
        scene_of({{{0.0, 0.0, 0.0}, smallest, {}, false}}),
        scene_of({{{0.0, 0.0, 0.0}, 1e-300, {}, false}, {{1e-299, 0.0, 0.0}, smallest, {}, false}}),
        scene_of({{{1e300, 0.0, 0.0}, 1e-300, {}, false}}),
        scene_of({{{1e300, 0.0, -1e300}, 1e299, {}, false}, {{-1e300, 1e300, 0.0}, 1.0, {}, false}}),
        scene_of({{{1e-300, 0.0, 0.0}, 1e300, {}, false}}),
        scene_of({{{1e306, 0.0, 0.0}, 1e306, {}, false}, {{-1e306, 1e306, 0.0}, 1.0, {}, false}}),
    };
    for (const Scene& scene : scenes) {
        for (const std::string& name : views) {
            SCOPED_TRACE(name + " of " + std::to_string(&scene - scenes.data()));
            expect_inside(scene, view(name));
        }
    }
    // No eye is far enough away to see these whole.
    for (const Scene& scene : {scene_of({{{0.0, 0.0, 0.0}, most, {}, false}}),
                               scene_of({{{most, most, most}, most, {}, false}, {{-most, -most, -most}, smallest, {}, false}})}) {
        for (const std::string& name : views) {
            SCOPED_TRACE(name);
            const std::optional<Camera> camera = fitted(scene, view(name));
            ASSERT_TRUE(camera);
            EXPECT_FALSE(camera_fault(*camera));
        }
    }
}

TEST(Fit, TinyScenesFillThePictureAsOthersDo) {
    for (const double size : {1e-250, 1e-280, 1e-300}) {
        const Scene scene = scene_of({{{0.0, 0.0, 5.0 * size}, size, {}, false}, {{2.0 * size, 0.0, 6.0 * size}, size, {}, false}});
        for (const std::string& name : views) {
            SCOPED_TRACE(name + " of size " + std::to_string(std::log10(size)));
            expect_tight(scene, view(name));
        }
    }
}

TEST(Fit, ViewsLookFromTheirSides) {
    const glm::dvec3 x{1.0, 0.0, 0.0};
    const glm::dvec3 y{0.0, 1.0, 0.0};
    const glm::dvec3 z{0.0, 0.0, 1.0};
    const std::vector<std::pair<std::vector<std::string>, ViewAxes>> cases = {
        {{"front", "0,0", "360,0", "-720,0"}, {x, y, z}},
        {{"right", "90,0", "-270,0"}, {z, y, -x}},
        {{"back", "180,0", "-180,0"}, {-x, y, -z}},
        {{"left", "270,0", "-90,0"}, {-z, y, x}},
        {{"top", "0,90", "360,90"}, {x, z, -y}},
        {{"bottom", "0,-90"}, {x, -z, y}},
        {{"90,90"}, {z, -x, -y}},
    };
    for (const auto& [names, axes] : cases) {
        for (const std::string& name : names) {
            SCOPED_TRACE(name);
            const ViewAxes found = view(name);
            expect_axes(found, axes);
            for (const glm::dvec3& v : {found.right, found.up, found.ahead}) {
                for (int i = 0; i < 3; ++i) EXPECT_FALSE(v[i] == 0.0 && std::signbit(v[i]));
            }
        }
    }
    EXPECT_LT(glm::distance(view("iso").ahead, std::sqrt(1.0 / 3.0) * (z - x - y)), 1e-15);
}

TEST(Fit, AViewsWordsAreRefusedUnlessTheySayOne) {
    for (const char* text :
         {"", "Front", "side", "1", "1,", ",1", "1,2,3", "1;2", "nan,0", "inf,0", "0,90.1", "0,-91", "a,b", "1 ,2"}) {
        EXPECT_FALSE(parse_view(text)) << text;
    }
    for (const char* text : {"1,2", "-1.5e2,+90", "1e300,0"}) EXPECT_TRUE(parse_view(text)) << text;
}

TEST(Fit, ACamerasAxesAreThoseItWasMadeOf) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        Random random(9000 + seed);
        ViewAxes axes = axes_from(random.between(-400.0, 400.0), random.between(-90.0, 90.0));
        if (seed % 2 == 1) axes.right = -axes.right;
        const double size = std::exp(random.between(-600.0, 600.0));
        expect_axes(axes_of({{0.0, 0.0, 0.0}, size * axes.ahead, size * axes.right, size * axes.up}), axes, 1e-14);
    }
    expect_axes(axes_of({}), ViewAxes());
}

TEST(Fit, SinesAndCosinesAreWithinTheirBounds) {
    const auto check = [](double degrees) {
        // Reduced exactly, as doubles allow.
        const double turn = std::fmod(degrees, 360.0);
        const long double radians = static_cast<long double>(turn) * (std::acos(-1.0L) / 180.0L);
        const auto [sine, cosine] = sine_cosine(degrees);
        EXPECT_NEAR(sine, static_cast<double>(std::sin(radians)), 0x1p-51) << degrees;
        EXPECT_NEAR(cosine, static_cast<double>(std::cos(radians)), 0x1p-51) << degrees;
    };
    for (int degrees = -720; degrees <= 720; ++degrees) check(degrees);
    Random random(42);
    for (int i = 0; i < 20000; ++i) check(random.between(-1000.0, 1000.0));
    for (int i = 0; i < 1000; ++i) {
        const double small = std::exp(random.between(-700.0, 0.0));
        const double exact = static_cast<double>(std::sin(static_cast<long double>(small) * (std::acos(-1.0L) / 180.0L)));
        EXPECT_NEAR(sine_cosine(small).sine, exact, exact * 0x1p-51 + std::numeric_limits<double>::denorm_min());
    }
    for (const double huge : {1e22, 1e300, std::numeric_limits<double>::max()}) check(huge);
    for (int quarters = -8; quarters <= 8; ++quarters) {
        const auto [sine, cosine] = sine_cosine(90.0 * quarters);
        EXPECT_EQ(std::fabs(sine) + std::fabs(cosine), 1.0);
    }
}

TEST(Fit, TheOrderOfSpheresDoesNotMatter) {
    Random random(1);
    Scene scene;
    for (int i = 0; i < 100000; ++i) scene.spheres.push_back({random.in_cube(1.0), random.between(1e-4, 1e-2), {}, false});
    const Camera camera = fitted(scene, view("iso")).value();
    std::ranges::reverse(scene.spheres);
    EXPECT_EQ(fitted(scene, view("iso")).value(), camera);
}

}  // namespace sphereview

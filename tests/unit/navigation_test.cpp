#include "camera/navigation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <ostream>

#include "oracle/random.hpp"
#include "unit/projection.hpp"

namespace sphereview {

void PrintTo(const Camera& camera, std::ostream* out) {
    out->precision(17);
    for (const glm::dvec3& v : {camera.eye, camera.center, camera.right, camera.up}) {
        *out << "(" << v.x << ", " << v.y << ", " << v.z << ") ";
    }
}

namespace {

using oracle::Random;

constexpr double pi = std::numbers::pi;
constexpr glm::dvec3 y_axis{0.0, 1.0, 0.0};

glm::dvec3 direction(Random& random) {
    while (true) {
        const glm::dvec3 v = random.in_cube(1.0);
        if (glm::length(v) > 0.1 && glm::length(v) < 1.0) return glm::normalize(v);
    }
}

// Any size, roll and offset from the axis; now and then mirrored, level, upside down or looking straight along y.
Camera any_camera(Random& random, double scale) {
    glm::dvec3 ahead = direction(random);
    if (random.chance(0.1)) ahead = random.chance(0.5) ? y_axis : -y_axis;
    const glm::dvec3 helper = random.chance(0.5) && std::fabs(ahead.y) < 0.99 ? y_axis : direction(random);
    glm::dvec3 right = glm::normalize(glm::cross(helper, ahead));
    glm::dvec3 up = glm::cross(ahead, right);
    if (random.chance(0.2)) right = -right, up = -up;
    if (random.chance(0.2)) right = -right;
    const double half = scale * random.of_size(0.1, 10.0);
    Camera camera;
    camera.eye = random.in_cube(scale * 10.0);
    camera.right = half * right;
    camera.up = half * up;
    camera.center = camera.eye + scale * random.of_size(0.2, 20.0) * ahead;
    if (random.chance(0.5)) camera.center += random.between(-3, 3) * camera.right + random.between(-3, 3) * camera.up;
    EXPECT_FALSE(camera_fault(camera));
    return camera;
}

glm::dvec2 any_place(Random& random, PictureSize size) {
    return {random.between(0.0, size.width), random.between(0.0, size.height)};
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
    EXPECT_LE(glm::length(a - b), tolerance) << a.x << ", " << a.y << ", " << a.z << " and " << b.x << ", " << b.y << ", " << b.z;
}

constexpr double tolerance = 1e-5;  // pixels of a picture 1000 pixels wide

// That the camera has no fault, and shows the point at that place.
void expect_shown(const Camera& camera, PictureSize size, const glm::dvec3& point, const glm::dvec2& place,
                  double within = tolerance) {
    ASSERT_FALSE(camera_fault(camera));
    const auto shown = project(camera, size, point);
    ASSERT_TRUE(shown);
    EXPECT_LT(glm::length(*shown - place) * 1000.0 / size.shorter_side(), within);
}

struct Trial {
    Random& random;
    double scale;
    Camera camera;
    PictureSize size{random.whole(1, 2000), random.whole(1, 2000)};
    glm::dvec2 place = any_place(random, size);
};

void expect_in_trials(std::uint64_t seed, int trials, const std::function<void(Trial)>& holds) {
    Random random(seed);
    for (int trial = 0; trial < trials && !testing::Test::HasFailure(); ++trial) {
        SCOPED_TRACE("trial " + std::to_string(trial));
        const double scale = std::pow(10.0, 3 * (trial % 6) - 6);
        holds({random, scale, any_camera(random, scale)});
    }
}

}  // namespace

TEST(Project, IsWhatTheRayOfThePixelGoesThrough) {
    // The design's formula: D = (50 (2i + 1 - W) / m, 50 (H - 1 - 2j) / m, 100), and P = t D.
    for (const PictureSize size : {PictureSize{1000, 1000}, PictureSize{1600, 900}, PictureSize{3, 8}}) {
        const double m = size.shorter_side();
        for (const Pixel pixel : {Pixel{0, 0}, Pixel{size.width - 1, 0}, Pixel{1, size.height - 1}, Pixel{2, 2}}) {
            const glm::dvec3 ray(50.0 * (2 * pixel.x + 1 - size.width) / m, 50.0 * (size.height - 1 - 2 * pixel.y) / m, 100.0);
            const glm::dvec2 place(pixel.x + 0.5, pixel.y + 0.5);
            expect_shown({}, size, 3.0 * ray, place, 1e-9);
            expect_near(point_at({}, size, place, 3.0), 3.0 * ray, 1e-9);
        }
    }
}

TEST(Project, AgreesWithTheRayCoefficientsOfAnyCamera) {
    expect_in_trials(1, 2000, [](const Trial& t) {
        const Pixel pixel{t.random.whole(0, t.size.width - 1), t.random.whole(0, t.size.height - 1)};
        const RayCoefficients ray = ray_coefficients(t.size, pixel);
        const double m = t.size.shorter_side();
        const glm::dvec3 d = (t.camera.center - t.camera.eye) + static_cast<double>(ray.across) / m * t.camera.right +
                             static_cast<double>(ray.upward) / m * t.camera.up;
        expect_shown(t.camera, t.size, t.camera.eye + t.random.of_size(0.1, 10.0) * d, {pixel.x + 0.5, pixel.y + 0.5});
    });
}

TEST(Project, IsTheInverseOfPointAt) {
    expect_in_trials(2, 5000, [](const Trial& t) {
        const double depth = t.random.of_size(1e-2, 1e3);
        const glm::dvec3 point = point_at(t.camera, t.size, t.place, depth);
        EXPECT_NEAR(depth_of(t.camera, point) / depth, 1.0, 1e-9);
        expect_shown(t.camera, t.size, point, t.place);
    });
    // Not quite perpendicular is allowed, and the ray formula takes it as it is.
    const Camera camera{{0, 0, 0}, {0, 0, 100}, {50, 0, 0}, {50 * 0.9e-6, 50, 0}};
    expect_shown(camera, {}, point_at(camera, {}, {10, 20}, 2.0), {10, 20}, 1e-9);
}

TEST(Project, ShowsNothingThatIsNotBeforeTheEye) {
    EXPECT_FALSE(project({}, {}, {0, 0, 0}));
    EXPECT_FALSE(project({}, {}, {5, 5, 0}));
    EXPECT_FALSE(project({}, {}, {0, 0, -100}));
    EXPECT_TRUE(project({}, {}, {0, 0, 1e-3}));
    EXPECT_EQ(depth_of({}, {7, 7, 100}), 1.0);
    EXPECT_EQ(depth_of({}, {7, 7, -50}), -0.5);
}

TEST(Orbited, KeepsThePivotsPixelAndDistance) {
    expect_in_trials(3, 5000, [](const Trial& t) {
        const glm::dvec3 pivot = point_at(t.camera, t.size, t.place, t.random.of_size(0.1, 10.0));
        const Camera moved = orbited(t.camera, pivot, t.random.between(-7, 7), t.random.between(-4, 4));
        expect_shown(moved, t.size, pivot, t.place);
        EXPECT_NEAR(glm::length(moved.eye - pivot) / glm::length(t.camera.eye - pivot), 1.0, 1e-9);
        EXPECT_NEAR(glm::length(moved.right) / glm::length(t.camera.right), 1.0, 1e-12);
    });
}

TEST(Orbited, TakesWhatLiesBeforeThePivotAlongWithThePointer) {
    expect_in_trials(4, 2000, [](const Trial& t) {
        const glm::dvec3 ahead = camera_axes(t.camera).ahead;
        const double height = std::fabs(glm::dot(glm::normalize(t.camera.up), y_axis));
        if (height < 0.1 || std::fabs(ahead.y) > 0.99) return;
        const glm::dvec3 pivot = t.camera.center + ahead * glm::length(t.camera.right);
        // The pivot is beside it in an off-axis picture; what counts is how the one moves against the other.
        const auto shift = [&](double turn, double tilt) {
            const Camera moved = orbited(t.camera, pivot, turn, tilt);
            return *project(moved, {}, t.camera.center) - *project(t.camera, {}, t.camera.center);
        };
        EXPECT_GT(shift(1e-3, 0.0).x, 0.0);
        EXPECT_LT(shift(-1e-3, 0.0).x, 0.0);
        EXPECT_GT(shift(0.0, 1e-3).y, 0.0);
        EXPECT_LT(shift(0.0, -1e-3).y, 0.0);
    });
}

TEST(Orbited, StopsAtThePoles) {
    Random random(5);
    const glm::dvec3 pivot{0.0, 0.0, 200.0};
    for (int trial = 0; trial < 3000; ++trial) {
        SCOPED_TRACE("trial " + std::to_string(trial));
        const Camera begin = any_camera(random, 1.0);
        const bool upright = begin.up.y > 1e-3 * glm::length(begin.up);
        const bool upside_down = begin.up.y < -1e-3 * glm::length(begin.up);
        if (!upright && !upside_down) continue;
        // Once far beyond the pole, then a thousand small steps, with turns that must not matter.
        for (const double towards : {1.0, -1.0}) {
            Camera camera = orbited(begin, pivot, 0.0, towards * random.between(4.0, 40.0));
            for (int step = 0; step < 50; ++step) camera = orbited(camera, pivot, random.between(-4, 4), towards * 0.01);
            ASSERT_FALSE(camera_fault(camera));
            EXPECT_EQ(camera.up.y > 0.0, upright);
            EXPECT_LT(std::fabs(camera.up.y), 2e-4 * glm::length(camera.up));
            // As high or low as the roll lets it.
            const double highest = std::sqrt(1.0 - std::pow(glm::dot(glm::normalize(begin.right), y_axis), 2));
            EXPECT_NEAR(std::fabs(camera_axes(camera).ahead.y), highest, 1e-6);
            // And back again, to the other pole.
            camera = orbited(camera, pivot, 0.0, -towards * (pi - 2e-4));
            EXPECT_LT(std::fabs(camera.up.y), 2e-4 * glm::length(camera.up));
            EXPECT_EQ(camera.up.y > 0.0, upright);
        }
    }
}

TEST(Orbited, LeavesAPoleThatItBeganAtAndHasNoneForACameraOnItsSide) {
    const glm::dvec3 pivot{0.0, -200.0, 0.0};
    const Camera down{{0, 0, 0}, {0, -100, 0}, {50, 0, 0}, {0, 0, 50}};
    expect_near(orbited(down, pivot, 0.0, 1.0).eye, {0, 0, 0}, 1e-9);
    const Camera level = orbited(down, pivot, 0.0, -pi / 2.0);
    expect_near(level.eye, {0, -200, -200}, 1e-9);
    expect_near(level.up, {0, 50, 0}, 1e-9);
    expect_near(orbited(down, pivot, pi / 2.0, 0.0).up, {50, 0, 0}, 1e-9);
    const Camera side{{0, 0, 0}, {0, 0, 100}, {0, 50, 0}, {-50, 0, 0}};
    expect_near(orbited(side, {0, 0, 100}, 0.0, 2.5).center, {0, 0, 100}, 1e-9);
    expect_near(orbited(side, {0, 0, 100}, 0.0, pi).eye, {0, 0, 200}, 1e-9);
}

TEST(Tumbled, KeepsThePivotsPixelAndDistance) {
    expect_in_trials(31, 2000, [](const Trial& t) {
        const glm::dvec3 pivot = point_at(t.camera, t.size, t.place, t.random.of_size(0.1, 10.0));
        const Camera moved = tumbled(t.camera, pivot, t.random.between(-7, 7), t.random.between(-7, 7));
        expect_shown(moved, t.size, pivot, t.place);
        EXPECT_NEAR(glm::length(moved.eye - pivot) / glm::length(t.camera.eye - pivot), 1.0, 1e-9);
        EXPECT_EQ(camera_axes(moved).mirrored, camera_axes(t.camera).mirrored);
    });
}

TEST(Tumbled, PassesThePolesAndFollowsThePointer) {
    // Half a circle of tilts from the front: the eye is behind, upside down. A turntable ends at the pole.
    const glm::dvec3 pivot{0.0, 0.0, 300.0};
    Camera ball;
    Camera table;
    for (int i = 0; i < 100; ++i) {
        ball = tumbled(ball, pivot, 0.0, pi / 100.0);
        table = orbited(table, pivot, 0.0, pi / 100.0);
    }
    expect_near(ball.eye, {0.0, 0.0, 600.0}, 1e-9);
    EXPECT_LT(ball.up.y, -49.9);
    EXPECT_GT(table.eye.y, 299.0);
    const glm::dvec2 place = *project(tumbled({}, pivot, 0.1, 0.1), {}, {0.0, 0.0, 290.0});
    EXPECT_GT(place.x, 500.0);
    EXPECT_GT(place.y, 500.0);
}

TEST(TurnedTo, HasTheAxesAndThePivotWhereItWas) {
    expect_in_trials(32, 2000, [](const Trial& t) {
        const glm::dvec3 pivot = point_at(t.camera, t.size, t.place, t.random.of_size(0.1, 10.0));
        CameraAxes axes{{0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}};
        const bool mirrored = camera_axes(t.camera).mirrored;
        if (mirrored) axes.right = -axes.right;
        const Camera moved = turned_to(t.camera, pivot, axes);
        expect_shown(moved, t.size, pivot, t.place);
        const CameraAxes found = camera_axes(moved);
        expect_near(found.right, axes.right, 1e-9);
        expect_near(found.up, axes.up, 1e-9);
        expect_near(found.ahead, axes.ahead, 1e-9);
        EXPECT_EQ(found.mirrored, mirrored);
    });
}

TEST(Panned, MovesWhatLiesAtTheDepthByThePixels) {
    expect_in_trials(6, 5000, [](const Trial& t) {
        const double depth = t.random.of_size(0.1, 10.0);
        const glm::dvec2 to = any_place(t.random, t.size);
        const Camera moved = panned(t.camera, t.size, to - t.place, depth);
        const glm::dvec3 point = point_at(t.camera, t.size, t.place, depth);
        expect_shown(moved, t.size, point, to);
        EXPECT_NEAR(depth_of(moved, point) / depth, 1.0, 1e-9);
    });
}

TEST(Zoomed, KeepsThePixelAndScalesTheDistance) {
    expect_in_trials(7, 5000, [](const Trial& t) {
        const glm::dvec3 point = point_at(t.camera, t.size, t.place, t.random.of_size(0.1, 10.0));
        const double factor = t.random.of_size(0.01, 100.0);
        const Camera moved = zoomed(t.camera, point, factor);
        EXPECT_NEAR(glm::length(moved.eye - point) / glm::length(t.camera.eye - point) / factor, 1.0, 1e-9);
        expect_shown(moved, t.size, point, t.place);
    });
}

TEST(Zoomed, GoesAsNearAndAsFarAsDoublesAllowAndBackAgain) {
    const glm::dvec3 point{30.0, 20.0, 200.0};
    const glm::dvec2 place = *project({}, {}, point);
    Camera camera;
    for (const double factor : {0.8, 1.25, 1.25, 0.8}) {
        SCOPED_TRACE(factor);
        for (int i = 0; i < 5000; ++i) camera = zoomed(camera, point, factor);
        expect_shown(camera, {}, point, place, 0.01);
    }
    EXPECT_LT(glm::length(camera.eye - point), 1e-3);
}

// All moves of an orthographic camera: what is under the pointer stays there, and nothing but a turn moves the picture's plane.
TEST(Orthographic, MovesAndZoomsAlongItsPlane) {
    expect_in_trials(9, 3000, [](const Trial& t) {
        Camera camera = t.camera;
        camera.projection = Projection::orthographic;
        const double depth = t.random.of_size(0.1, 10.0);
        const glm::dvec3 point = point_at(camera, t.size, t.place, depth);
        EXPECT_NEAR(depth_of(camera, point) / depth, 1.0, 1e-9);
        expect_shown(camera, t.size, point, t.place);
        const glm::dvec3 ahead = camera_axes(camera).ahead;
        const auto expect_same_plane = [&](const Camera& moved) {
            EXPECT_EQ(moved.projection, Projection::orthographic);
            EXPECT_NEAR(glm::dot(ahead, moved.eye - camera.eye) / t.scale, 0.0, 1e-7);
        };

        const glm::dvec2 to = any_place(t.random, t.size);
        const Camera moved = panned(camera, t.size, to - t.place, t.random.of_size(0.1, 10.0));
        expect_shown(moved, t.size, point, to);
        expect_same_plane(moved);

        const double factor = t.random.of_size(0.01, 100.0);
        const Camera near = zoomed(camera, point, factor);
        expect_shown(near, t.size, point, t.place);
        expect_same_plane(near);
        EXPECT_NEAR(glm::length(near.right) / glm::length(camera.right) / factor, 1.0, 1e-9);

        const Camera orbiting = orbited(camera, point, 0.3, 0.2);
        EXPECT_EQ(orbiting.projection, Projection::orthographic);
        EXPECT_NEAR(glm::length(orbiting.eye - point) / glm::length(camera.eye - point), 1.0, 1e-9);
    });
}

TEST(WithProjection, KeepsWhatLiesAtTheDepthAndComesBack) {
    expect_in_trials(10, 3000, [](const Trial& t) {
        const double depth = t.random.of_size(0.1, 10.0);
        const glm::dvec3 point = point_at(t.camera, t.size, t.place, depth);
        const Camera parallel = with_projection(t.camera, Projection::orthographic, depth);
        expect_shown(parallel, t.size, point, t.place);
        EXPECT_EQ(parallel.eye, t.camera.eye);
        const Camera back = with_projection(parallel, Projection::perspective, depth_of(parallel, point));
        expect_shown(back, t.size, point, t.place);
        EXPECT_LE(glm::length(back.eye - t.camera.eye) / t.scale, 1e-6);
        // After a zoom the angle of view is the old one, too.
        const Camera near = zoomed(parallel, point, 0.25);
        const Camera from_near = with_projection(near, Projection::perspective, depth_of(near, point));
        expect_shown(from_near, t.size, point, t.place);
        const auto angle = [](const Camera& camera) { return glm::length(camera.right) / glm::length(camera.center - camera.eye); };
        EXPECT_NEAR(angle(from_near) / angle(t.camera), 1.0, 1e-6);
    });
    EXPECT_EQ(with_projection({}, Projection::perspective, 3.0), Camera());
}

TEST(CenteredOn, PutsThePointInTheMiddleAsDeepAsBefore) {
    expect_in_trials(8, 5000, [](const Trial& t) {
        const glm::dvec3 point = t.random.in_cube(100.0 * t.scale);
        const double depth = std::fabs(depth_of(t.camera, point));
        const Camera moved = centered_on(t.camera, point);
        expect_shown(moved, {}, point, {500.0, 500.0}, tolerance / std::min(1.0, depth));
        EXPECT_NEAR(depth_of(moved, point) / depth, 1.0, 1e-6 / std::min(1.0, depth));
    });
    EXPECT_EQ(centered_on({}, {0, 0, 0}).eye, glm::dvec3(0, 0, -100));
}

TEST(Navigation, NeverLeadsToAFaultyCamera) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double scale = std::pow(10.0, 3.0 * static_cast<double>(seed % 6) - 6.0);
        Camera camera = seed <= 2 ? Camera{} : any_camera(random, scale);
        const auto shape_of = [](const Camera& c) {
            const glm::dvec3 axis = c.center - c.eye;  // wherever it has gone: the squares may be too large
            return std::hypot(c.right.x, c.right.y, c.right.z) / std::hypot(axis.x, axis.y, axis.z);
        };
        const double shape = shape_of(camera);
        const PictureSize size{1000, 700};
        bool moved = false;
        for (int i = 0; i < 10000; ++i) {
            const bool wild = random.chance(0.01);
            const double depth = wild ? random.of_size(1e-12, 1e12) : random.of_size(0.1, 10.0);
            const glm::dvec3 point = point_at(camera, size, any_place(random, size), depth);
            const Camera before = camera;
            switch (random.whole(0, 3)) {
                case 0: camera = orbited(camera, point, random.between(-3, 3), random.between(-3, 3)); break;
                case 1: camera = panned(camera, size, any_place(random, size) - any_place(random, size), depth); break;
                case 2: camera = zoomed(camera, point, wild ? random.of_size(1e-9, 1e9) : random.of_size(0.5, 2.0)); break;
                default: camera = centered_on(camera, wild ? point : random.in_cube(scale)); break;
            }
            const auto fault = camera_fault(camera);
            ASSERT_FALSE(fault) << fault->what << " after operation " << i;
            moved = moved || !(camera == before);
        }
        EXPECT_TRUE(moved);
        EXPECT_NEAR(shape_of(camera) / shape, 1.0, 1e-3);
    }
}

TEST(Navigation, StaysWhereNumbersEnd) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    const Camera camera;
    const glm::dvec3 point{0, 0, 200};
    for (const double bad : {nan, infinite, -infinite}) {
        EXPECT_EQ(orbited(camera, point, bad, 0.0), camera);
        EXPECT_EQ(panned(camera, {}, {bad, 0.0}, 1.0), camera);
        EXPECT_EQ(panned(camera, {}, {1.0, 0.0}, bad), camera);
        EXPECT_EQ(zoomed(camera, point, bad), camera);
        EXPECT_EQ(centered_on(camera, {bad, 0, 0}), camera);
    }
    EXPECT_EQ(orbited(camera, point, 0.0, nan), camera);
    EXPECT_EQ(zoomed(camera, point, 0.0), camera);
    EXPECT_EQ(zoomed(camera, point, -1.0), camera);
    EXPECT_EQ(zoomed(camera, point, 1e308), camera);
}

}  // namespace sphereview

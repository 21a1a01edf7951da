// The bits of fitted cameras: a machine, a compiler or a library on which they differ renders other pictures. Compiled with several
// sets of flags as well.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "camera/fit.hpp"
#include "camera/turntable.hpp"
#include "oracle/random.hpp"

namespace sphereview {
namespace {

// FNV-1a over the numbers' bytes, the lowest first.
class Digest {
public:
    void add(double number) {
        auto bits = std::bit_cast<std::uint64_t>(number);
        for (int i = 0; i < 8; ++i, bits >>= 8) hash_ = (hash_ ^ (bits & 0xff)) * 0x100000001b3;
    }
    void add(const glm::dvec3& v) {
        for (int i = 0; i < 3; ++i) add(v[i]);
    }
    std::uint64_t hash() const { return hash_; }

private:
    std::uint64_t hash_ = 0xcbf29ce484222325;
};

Scene some_scene() {
    oracle::Random random(17);
    Scene scene;
    for (int i = 0; i < 50; ++i) scene.spheres.push_back({random.in_cube(10.0), random.between(0.1, 2.0), {}, i % 7 == 3});
    return scene;
}

}  // namespace

TEST(FitBits, OfSinesAndCosines) {
    Digest digest;
    for (int i = -4000; i <= 4000; ++i) {
        const auto [sine, cosine] = sine_cosine(0.1 * i);
        digest.add(sine + 0.0);
        digest.add(cosine + 0.0);
    }
    EXPECT_EQ(digest.hash(), 0x1d4f8eb630a94618U);
    EXPECT_EQ(sine_cosine(30.0).sine, 0x1.fffffffffffffp-2);
    EXPECT_EQ(sine_cosine(30.0).cosine, 0x1.bb67ae8584cabp-1);
    EXPECT_EQ(sine_cosine(-123.456).sine, -0x1.ab2a9b25a9ab9p-1);
    EXPECT_EQ(sine_cosine(-123.456).cosine, -0x1.1a43870d371f9p-1);
}

TEST(FitBits, OfTurnedCameras) {
    Digest digest;
    for (const TurnAxis axis : {TurnAxis::up, TurnAxis::x, TurnAxis::y, TurnAxis::z}) {
        const ViewAxes axes = parse_view("30,20").value();
        const Camera camera = fitted(some_scene(), axes).value();
        const Turn turn(axes, axis);
        for (int i = 0; i < 97; ++i) {
            const Camera turned = turn.camera(camera, {0.1, 0.2, 0.3}, degrees_of(i, 97));
            for (const glm::dvec3& vector : {turned.eye, turned.center, turned.right, turned.up}) digest.add(vector);
        }
    }
    EXPECT_EQ(digest.hash(), 0xb3258cf671dba357U);
}

TEST(FitBits, OfOneCamera) {
    const Camera camera = fitted(some_scene(), parse_view("30,20").value()).value();
    EXPECT_EQ(camera.eye, glm::dvec3(0x1.cc527e878af41p+3, 0x1.0adbc54878626p+3, -0x1.8887cda5ffc7bp+4));
    EXPECT_EQ(camera.center, glm::dvec3(-0x1.04cbe69b2076dp+5, -0x1.9dcd90bd3ef9bp+4, 0x1.c6c5dd0d3d0fcp+5));
    EXPECT_EQ(camera.right, glm::dvec3(0x1.5a6900584fbe6p+5, 0x0p+0, 0x1.8ffffffffffffp+4));
    EXPECT_EQ(camera.up, glm::dvec3(-0x1.119db9b0bd957p+3, 0x1.77e0863d0333ep+5, 0x1.d9eac15277438p+3));
}

TEST(FitBits, OfManyCameras) {
    Digest digest;
    oracle::Random random(18);
    const Scene scene = some_scene();
    for (int i = 0; i < 1000; ++i) {
        // In this order: compilers choose the order of a call's arguments.
        const double up = random.between(-90.0, 90.0);
        const double around = random.between(-400.0, 400.0);
        const ViewAxes axes = axes_from(around, up);
        const Camera camera = fitted(scene, axes).value();
        const Camera again = fitted(scene, axes_of(camera)).value();
        for (const Camera& one : {camera, again}) {
            for (const glm::dvec3& v : {one.eye, one.center, one.right, one.up}) digest.add(v);
        }
    }
    EXPECT_EQ(digest.hash(), 0x81f29acfb0d79470U);
}

}  // namespace sphereview

// The formulae of docs/shading.md: against the textbook's in long double, and by sums that every build must give.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "exact/drawn.hpp"
#include "exact/resolve.hpp"
#include "scene/vectors.hpp"
#include "shade/brightness.hpp"
#include "shade/picture_shader.hpp"
#include "shade/shading.hpp"
#include "support/shaded_scenes.hpp"
#include "support/spheres.hpp"

namespace sphereview {
namespace {

using Real = long double;
using Bytes = std::vector<int>;

constexpr PictureSize size{64, 48};

std::vector<std::int32_t> visible_in(const Scene& scene, PictureSize of) {
    const DrawnSpheres drawn = drawn_spheres(scene);
    const Resolver resolver(scene, drawn, of);
    std::vector<std::int32_t> visible;
    for (int y = 0; y < of.height; ++y) {
        for (int x = 0; x < of.width; ++x) {
            DecisionLevel level{};
            visible.push_back(resolver.resolve({x, y}, level));
        }
    }
    return visible;
}

Image shaded(const Scene& scene, PictureSize of, Shading shading) {
    Image picture(of.width, of.height, 3);
    PictureShader(scene, scene.camera, of, shading, scene.background)
        .shade({0, 0, of.width, of.height}, visible_in(scene, of), picture);
    return picture;
}

struct Vector {
    Real x, y, z;
};
Real dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector vector(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
Vector unit(const Vector& v) {
    const Real length = std::sqrt(dot(v, v));
    return {v.x / length, v.y / length, v.z / length};
}

// What a colour is made of, by the roots of the quadratic.
struct Reference {
    Real t;
    Vector normal;
    Real facing;
};

Reference reference(const Scene& scene, PictureSize of, Pixel pixel, const Sphere& sphere) {
    const Camera& camera = scene.camera;
    const Real m = of.shorter_side();
    const RayCoefficients k = ray_coefficients(of, pixel);
    const auto ray = [&](int axis) {
        return Real(camera.center[axis]) - camera.eye[axis] + k.across / m * camera.right[axis] + k.upward / m * camera.up[axis];
    };
    const Vector d = unit({ray(0), ray(1), ray(2)});
    const Vector c = vector(sphere.center - camera.eye);
    const Real r = sphere.radius;
    const Real b = dot(c, d);
    const Real rest = std::sqrt(std::max(b * b - (dot(c, c) - r * r), Real(0)));
    const bool inside = dot(c, c) <= r * r;
    const Real t = inside ? b + rest : b - rest;
    const Real sign = inside ? -1 : 1;
    const Vector n{sign * (t * d.x - c.x) / r, sign * (t * d.y - c.y) / r, sign * (t * d.z - c.z) / r};
    return {t, n, -dot(n, d)};
}

Real depth_of(const Scene& scene, Real t) {
    Real nearest = 1e30L;
    Real farthest = 0;
    for (const Sphere& sphere : scene.spheres) {
        const Vector c = vector(sphere.center - scene.camera.eye);
        const Real distance = std::sqrt(dot(c, c));
        nearest = std::min(nearest, std::fabs(distance - sphere.radius));
        farthest = std::max(farthest, distance < sphere.radius ? distance + sphere.radius : distance);
    }
    return std::clamp((t - nearest) / (farthest - nearest), Real(0), Real(1));
}

// A byte is right if the real number lies within a little more than half a step of it.
void expect_byte(int byte, Real value, const char* what) { EXPECT_NEAR(static_cast<double>(value), byte, 0.5 + 1e-6) << what; }

TEST(PictureShader, FollowsTheFormulae) {
    for (const Scene& scene : shaded_scenes()) {
        const std::vector<std::int32_t> visible = visible_in(scene, size);
        const Image headlight = shaded(scene, size, Shading::headlight);
        const Image normal = shaded(scene, size, Shading::normal);
        const Image depth = shaded(scene, size, Shading::depth);
        const Vector right = unit(vector(scene.camera.right));
        const Vector up = unit(vector(scene.camera.up));
        Vector toward{right.y * up.z - right.z * up.y, right.z * up.x - right.x * up.z, right.x * up.y - right.y * up.x};
        if (dot(toward, vector(scene.camera.center - scene.camera.eye)) > 0) toward = {-toward.x, -toward.y, -toward.z};
        int spheres = 0;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const std::int32_t number = visible[static_cast<std::size_t>(y * size.width + x)];
                if (number < 0) {
                    for (const Image* image : {&headlight, &normal, &depth}) EXPECT_EQ(image->at(x, y)[2], 3);
                    continue;
                }
                ++spheres;
                const Sphere& sphere = scene.spheres[static_cast<std::size_t>(number)];
                const Reference hit = reference(scene, size, {x, y}, sphere);
                const Real u = depth_of(scene, hit.t);
                expect_byte(headlight.at(x, y)[0], sphere.color.r * (0.3L + 0.7L * hit.facing / (1 + u)), "headlight");
                expect_byte(depth.at(x, y)[1], 255 * (1 - 0.8L * u), "depth");
                expect_byte(normal.at(x, y)[0], 127.5L * (1 + dot(hit.normal, right)), "normal, right");
                expect_byte(normal.at(x, y)[1], 127.5L * (1 + dot(hit.normal, up)), "normal, up");
                expect_byte(normal.at(x, y)[2], 127.5L * (1 + dot(hit.normal, toward)), "normal, toward the eye");
                const Color one = PictureShader(scene, scene.camera, size, Shading::normal, {}).color({x, y}, number);
                EXPECT_EQ(one, (Color{normal.at(x, y)[0], normal.at(x, y)[1], normal.at(x, y)[2]}));
            }
        }
        EXPECT_GT(spheres, 500);
    }
}

TEST(PictureShader, NeverFailsOnExtremeNumbers) {
    for (const double far : {1e-300, 1e-150, 1.0, 1e150, 1e300, 1.7e308}) {
        for (const double radius : {5e-324, 1e-300, 1e-3, 1e100, 1.7e308}) {
            Scene scene =
                scene_of({{{far, -far, far}, radius, {255, 255, 255}, false}, {{0, 0, far}, radius, {255, 255, 255}, false}});
            for (const Shading shading : {Shading::headlight, Shading::normal, Shading::depth, Shading::id}) {
                const PictureShader shader(scene, scene.camera, size, shading, {});
                for (const std::int32_t number : {0, 1}) {
                    const Color color = shader.color({31, 17}, number);
                    // Never darker than the ambient light at the far end, nor than the farthest grey.
                    if (shading == Shading::headlight) {
                        EXPECT_GE(color.r, 76);
                    }
                    if (shading == Shading::depth) {
                        EXPECT_GE(color.r, 51);
                    }
                }
            }
        }
    }
}

TEST(PictureShader, MakesATransparentBackgroundClearAndSpheresOpaque) {
    const Scene scene = shaded_scene(1, 1);
    for (const Shading shading : {Shading::flat, Shading::headlight, Shading::normal, Shading::depth, Shading::id}) {
        Image picture(2, 1, 4);
        const std::vector<std::int32_t> visible = {visible_background, 0};
        PictureShader(scene, scene.camera, {2, 1}, shading, {{0, 0, 0}, true}).shade({0, 0, 2, 1}, visible, picture);
        EXPECT_EQ(picture.at(0, 0)[3], 0);
        EXPECT_EQ(picture.at(1, 0)[3], 255);
    }
}

Scene red_and_blue() {
    Scene scene = scene_of_alike(2);
    scene.spheres[0].color = {255, 1, 2};
    scene.spheres[1].color = {3, 4, 254};
    scene.background = {{50, 50, 50}, false};  // another than each picture is given
    return scene;
}

void shade_flat(const Scene& scene, const Background& background, const Block& block, const std::vector<std::int32_t>& visible,
                Image& picture, Pixel origin = {}) {
    PictureShader(scene, scene.camera, {50, 50}, Shading::flat, background).shade(block, visible, picture, origin);
}

Bytes flat(const Scene& scene, const Background& background, std::vector<std::int32_t> visible) {
    Image picture = make_picture({static_cast<int>(visible.size()), 1}, background);
    shade_flat(scene, background, {0, 0, picture.width(), 1}, visible, picture);
    return {picture.bytes().begin(), picture.bytes().end()};
}

TEST(FlatShading, GivesEveryColourByteForByte) {
    EXPECT_EQ(flat(red_and_blue(), {}, {0, visible_background, 1}), (Bytes{255, 1, 2, 0, 0, 0, 3, 4, 254}));
    EXPECT_EQ(flat(red_and_blue(), {{9, 8, 7}, false}, {visible_background, 0}), (Bytes{9, 8, 7, 255, 1, 2}));
}

TEST(FlatShading, PutsABlockIntoAPartOfThePictureAndNothingOutside) {
    Image picture(4, 3, 3);
    std::ranges::fill(picture.bytes(), std::uint8_t{77});
    const std::vector<std::int32_t> visible = {0, 1};
    shade_flat(red_and_blue(), {}, {12, 21, 1, 2}, visible, picture, {10, 20});
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x) {
            const int red = x == 2 && y == 1 ? 255 : x == 2 && y == 2 ? 3 : 77;
            EXPECT_EQ(picture.at(x, y)[0], red) << x << "," << y;
        }
    }
}

TEST(IdColor, TellsNeighboursApart) {
    const auto distance = [](const Color& a, const Color& b) {
        return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
    };
    for (std::uint32_t i = 0; i < 2000; ++i) EXPECT_GT(distance(id_color(i), id_color(i + 1)), 100) << i;
    std::set<int> different;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const Color color = id_color(i);
        different.insert(color.r << 16 | color.g << 8 | color.b);
    }
    EXPECT_GT(different.size(), 900U);
}

TEST(DepthRange, IsOfAllThatIsNotHidden) {
    Scene scene;
    EXPECT_EQ(depth_range(scene, {}), DepthRange{});
    scene.spheres = {{{0, 0, 80}, 8, {}, false}, {{0, 0, 800}, 8, {}, false}, {{0, 0, 8000}, 8, {}, true}};
    EXPECT_EQ(depth_range(scene, {}), (DepthRange{9, 100}));
    EXPECT_EQ(depth_range(scene, {.eye = {0, 0, 76}}), (DepthRange{0.5, 90.5}));
}

// FNV-1a: these sums must come out on every machine, of every compiler at every level of optimisation.
std::uint64_t sum_of(Shading shading) {
    std::uint64_t sum = 14695981039346656037ULL;
    for (const Scene& scene : shaded_scenes()) {
        const Image picture = shaded(scene, {200, 150}, shading);
        for (const std::uint8_t byte : picture.bytes()) sum = (sum ^ byte) * 1099511628211ULL;
    }
    return sum;
}

TEST(Shading, GivesTheSameBytesEverywhere) {
    EXPECT_EQ(sum_of(Shading::headlight), 10755567152492019107ULL);
    EXPECT_EQ(sum_of(Shading::normal), 14993693324456632048ULL);
    EXPECT_EQ(sum_of(Shading::depth), 4061514986693747050ULL);
    EXPECT_EQ(sum_of(Shading::id), 15816985907994986407ULL);
}

// A light vector that stands for some lights: from below left to above right over the picture.
std::vector<LightVector> some_light(PictureSize of) {
    std::vector<LightVector> light;
    for (int y = 0; y < of.height; ++y) {
        for (int x = 0; x < of.width; ++x)
            light.push_back({(x - of.width / 2) * 1000003, y * 1500007 - 40000000, -300000007 + x * y});
    }
    return light;
}

TEST(Studio, GivesTheSameBytesEverywhere) {
    constexpr PictureSize of{200, 150};
    std::uint64_t sum = 14695981039346656037ULL;
    for (const Scene& scene : shaded_scenes()) {
        Image picture(of.width, of.height, 3);
        PictureShader(scene, scene.camera, of, Shading::studio, scene.background)
            .shade({0, 0, of.width, of.height}, visible_in(scene, of), picture, {}, some_light(of));
        for (const std::uint8_t byte : picture.bytes()) sum = (sum ^ byte) * 1099511628211ULL;
    }
    EXPECT_EQ(sum, 16548869827512253254ULL);
}

// Lengths may be of any size: what is 2^1072 times smaller has the same colours.
TEST(Shading, GivesTheSameBytesAtEveryScale) {
    Scene near = shaded_scene(40, 7);
    Scene parallel = near;
    parallel.camera = {{0, 0, 0}, {15, -10, 100}, {120, 0, 0}, {0, 120, 0}, Projection::orthographic};
    for (const Scene& scene : {near, parallel}) {
        const std::vector<std::int32_t> visible = visible_in(scene, size);
        const auto bytes = [&](const Scene& scaled, Shading shading) {
            Image picture(size.width, size.height, 3);
            PictureShader(scaled, scaled.camera, size, shading, scaled.background)
                .shade({0, 0, size.width, size.height}, visible, picture, {},
                       shading == Shading::studio ? some_light(size) : std::vector<LightVector>{});
            return Bytes(picture.bytes().begin(), picture.bytes().end());
        };
        for (const int exponent : {-1072, -1020, -1000, -900, -300, 300, 900, 1000}) {
            Scene scaled = scene;  // but for the direction ahead
            for (Sphere& sphere : scaled.spheres) {
                sphere.center = times_two_to(sphere.center, exponent);
                sphere.radius = std::ldexp(sphere.radius, exponent);
            }
            if (scene.camera.orthographic()) {
                scaled.camera.right = times_two_to(scene.camera.right, exponent);
                scaled.camera.up = times_two_to(scene.camera.up, exponent);
            }
            for (const Shading shading : {Shading::normal, Shading::studio}) {
                EXPECT_EQ(bytes(scaled, shading), bytes(scene, shading))
                    << exponent << ", " << name_of(shading) << (scene.camera.orthographic() ? ", parallel" : "");
            }
        }
    }
}

// A sphere of another size than the camera.
TEST(Shading, HasAScaleForEachSphere) {
    const auto color = [](double factor) {
        Scene scene;
        scene.camera.projection = Projection::orthographic;
        scene.spheres = {{factor * glm::dvec3(20, 8, 200), factor * 40, {255, 255, 255}, false}};
        return PictureShader(scene, scene.camera, {51, 51}, Shading::normal, {}).color({25, 25}, 0);
    };
    EXPECT_EQ(color(0x1p-1072), color(1.0));
    EXPECT_EQ(color(0x1p1000), color(1.0));
}

// 1.8 E / (0.8 + E) of the own colour, with E = n.B: 1.8 for light from where the surface faces.
TEST(Studio, IsTheFormula) {
    Scene scene = scene_of({{{0, 0, 200}, 20, {200, 100, 0}, false}});
    const PictureShader shader(scene, scene.camera, {101, 101}, Shading::studio, {});
    const auto color = [&](double toward_eye) {
        return shader.color({50, 50}, 0, {0, 0, static_cast<std::int32_t>(-toward_eye * light_one)});
    };
    EXPECT_EQ(color(1.0), (Color{200, 100, 0}));
    EXPECT_EQ(color(2.0), (Color{200, 100, 0}));
    EXPECT_EQ(color(0.4), (Color{120, 60, 0}));
    EXPECT_EQ(color(0.1), (Color{40, 20, 0}));
    // Without light: black. With any: not, unless the sphere is.
    EXPECT_EQ(color(0.0), (Color{0, 0, 0}));
    EXPECT_EQ(shader.color({50, 50}, 0, {0, 0, -1}), (Color{1, 1, 0}));
    EXPECT_EQ(shader.color({50, 50}, 0, {0, 0, 1}), (Color{1, 1, 0}));  // the normal rounds, and the light is exact
}

// What a draft has not decided yet is as bright as what moves.
TEST(Studio, AddsAFreeSky) {
    Scene scene;
    scene.spheres = {{{0, 0, 200}, 20, {200, 100, 0}, false}};
    const PictureShader shader(scene, scene.camera, {101, 101}, Shading::studio, {});
    const Light light{.lights = {}, .sky = 0.8, .key = 0.5, .sun = {}, .toward_key = {}};
    const double free = brightness_of_free_sky(light, {0.0, 0.0, 1.0});
    const auto red = [&](double toward_eye, double part) {
        Image picture(1, 1, 3);
        const std::vector<std::int32_t> visible = {0};
        const std::vector<LightVector> lit = {{0, 0, static_cast<std::int32_t>(-toward_eye * light_one)}};
        shader.shade({50, 50, 1, 1}, visible, picture, {50, 50}, lit, {light, part});
        return int{picture.at(0, 0)[0]};
    };
    const auto expected = [](double e) { return static_cast<int>(std::lround(200.0 * 1.8 * e / (0.8 + e))); };
    EXPECT_EQ(red(0.2, 0.0), expected(0.2));
    EXPECT_EQ(red(0.0, 1.0), expected(free));
    EXPECT_EQ(red(0.2, 0.25), expected(0.2 + 0.25 * free));
}

}  // namespace
}  // namespace sphereview

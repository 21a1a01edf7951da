// What lists of spheres by screen tiles may get wrong: spheres that end where tiles do, that begin equally near, that lie
// around, across or behind the eye's plane, that are larger than the picture or smaller than a pixel.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "oracle/scenes.hpp"

namespace sphereview::oracle {

namespace {

constexpr Color blue{0, 0, 255};

// No multiples of a tile's side among them, but for 64 x 16.
constexpr std::array<PictureSize, 8> sizes = {{{33, 35}, {67, 19}, {17, 71}, {129, 9}, {64, 16}, {203, 5}, {3, 261}, {41, 39}}};

std::string named(const std::string& kind) { return kind + ", SPHEREVIEW_SEED=" + std::to_string(seed()); }

std::string of_size(PictureSize size) { return " " + std::to_string(size.width) + "x" + std::to_string(size.height); }

// Twice the perpendicular part of a pixel's ray: (2x + 1 - W, H - 1 - 2y).
struct Ray {
    double across;
    double upward;
};

Ray ray_at(PictureSize size, Pixel pixel) {
    const RayCoefficients k = ray_coefficients(size, pixel);
    return {static_cast<double>(k.across), static_cast<double>(k.upward)};
}

glm::dvec3 direction(const Camera& camera, PictureSize size, Pixel pixel) {
    const Ray ray = ray_at(size, pixel);
    const double m = size.shorter_side();
    return camera.center - camera.eye + ray.across / m * camera.right + ray.upward / m * camera.up;
}

// A column or row on either side of a border between tiles with sides of 2 to 32 pixels.
int beside_border(int count, Random& random) {
    for (int side = 2 << random.whole(0, 4); side > 1; side /= 2) {
        if (side >= count) continue;
        return std::min(count - 1, side * random.whole(1, (count - 1) / side) - random.whole(0, 1));
    }
    return random.whole(0, count - 1);
}

Pixel pixel_at_border(PictureSize size, Random& random) {
    Pixel pixel{random.whole(0, size.width - 1), random.whole(0, size.height - 1)};
    const bool of_columns = size.height < 3 || (size.width > 2 && random.chance(0.5));
    if (of_columns || random.chance(0.3)) pixel.x = beside_border(size.width, random);
    if (!of_columns || random.chance(0.3)) pixel.y = beside_border(size.height, random);
    return pixel;
}

double nudged(double value, Random& random) {
    switch (random.whole(0, 5)) {
        case 0: return std::nextafter(value, HUGE_VAL);
        case 1: return std::nextafter(value, 0.0);
        case 2: return value * (1.0 + random.of_size(0x1p-50, 0x1p-10));
        case 3: return value * (1.0 - random.of_size(0x1p-50, 0x1p-10));
        default: return value;
    }
}

Camera turned(const glm::dvec3& eye, const glm::dvec3& forward, double across, double distance, double edge) {
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.3, 1.0, -0.2), forward));
    const glm::dvec3 up = glm::cross(glm::normalize(forward), right);
    Camera camera;
    camera.eye = eye;
    camera.center = eye + distance * glm::normalize(forward) + across * edge * (right - 0.6 * up);
    camera.right = edge * right;
    camera.up = edge * up;
    return camera;
}

struct NamedCamera {
    std::string name;
    Camera camera;
};

std::vector<NamedCamera> cameras() {
    Camera mirrored;
    mirrored.right = {0, 50, 0};
    mirrored.up = {50, 0, 0};
    return {{"as usual", {}},
            {"mirrored", mirrored},
            {"turned", turned({10, -200, 35}, {-3, 1, 2}, 0.0, 100.0, 60.0)},
            {"oblique", turned({0, 0, 0}, {1, 2, -5}, 4.0, 100.0, 50.0)},
            {"very oblique", turned({1, 2, 3}, {0, 0, 1}, 30.0, 10.0, 10.0)},
            {"wide", turned({0, 50, 0}, {1, 0, 1}, 0.0, 5.0, 100.0)},
            {"very wide and oblique", turned({0, 0, 0}, {-1, -1, 4}, 0.02, 0.1, 100.0)},
            {"narrow", turned({5, 5, 5}, {-2, 1, 0}, 0.0, 1000.0, 1.0)}};
}

// Spheres in exact contact with the plane of a column of pixel centres (or a row), at a pixel centre each. The rays are
// (3a, 3b, 4c) in whole numbers, a and b as in ray_at(), c that of the column: its plane has the normal (4, 0, -3).
void add_exact_tangents(Trials& trials, Random& random) {
    for (std::size_t i = 0; i < 3 * sizes.size(); ++i) {
        const PictureSize size = sizes[i % sizes.size()];
        const bool column = size.height < 9 || (size.width > 8 && random.chance(0.5));
        const int at = beside_border(column ? size.width : size.height, random);
        const Ray there = ray_at(size, {column ? at : 0, column ? 0 : at});
        const double c = column ? there.across : there.upward;
        if (c == 0.0) continue;
        const double m = size.shorter_side();
        Trial trial{named("tangent at a tile's border") + of_size(size), {}, size};
        trial.scene.camera.center = {0, 0, std::fabs(4.0 * c)};
        trial.scene.camera.right = {3.0 * m, 0, 0};
        trial.scene.camera.up = {0, 3.0 * m, 0};
        const int along = column ? size.height : size.width;
        for (int k = 0; k < along; k += 1 + along / 70) {
            const Ray ray = ray_at(size, column ? Pixel{at, k} : Pixel{k, at});
            const glm::dvec3 foot(3.0 * ray.across, 3.0 * ray.upward, std::fabs(4.0 * c));
            const double sign = c > 0.0 ? 1.0 : -1.0;
            const glm::dvec3 normal = column ? glm::dvec3(4, 0, -3.0 * sign) : glm::dvec3(0, 4, -3.0 * sign);
            // Some are seen through a part of a pixel, others hang over the picture's edges.
            const double part = std::ldexp(random.chance(0.5) ? 1.0 : -1.0, random.whole(-12, 7));
            const double depth = random.whole(2, 40);
            const double radius = 5.0 * std::fabs(part);
            trial.scene.spheres.push_back(
                {depth * foot + part * normal, random.chance(0.3) ? nudged(radius, random) : radius, blue});
        }
        trials.push_back(trial);
    }
}

// The same for any camera, as nearly as double allows.
void add_near_tangents(Trials& trials, Random& random) {
    for (const NamedCamera& each : cameras()) {
        for (int i = 0; i < 4; ++i) {
            const PictureSize size = sizes[random.bits() % sizes.size()];
            Trial trial{named("nearly tangent at tiles' borders, camera " + each.name) + of_size(size), {}, size};
            const Camera& camera = trial.scene.camera = each.camera;
            for (int count = 0; count < 120; ++count) {
                const Pixel pixel = pixel_at_border(size, random);
                const glm::dvec3 ray = direction(camera, size, pixel);
                const glm::dvec3 side = glm::normalize(glm::cross(ray, random.chance(0.5) ? camera.up : camera.right));
                const double depth = random.of_size(0.2, 20.0);
                const double pixel_side = 2.0 * glm::length(camera.right) / size.shorter_side() * depth;
                const double radius = pixel_side * random.of_size(0.01, random.chance(0.2) ? 300.0 : 8.0);
                const glm::dvec3 center = camera.eye + depth * ray + (random.chance(0.5) ? radius : -radius) * side;
                trial.scene.spheres.push_back({center, nudged(radius, random), blue});
            }
            trials.push_back(trial);
        }
    }
}

// Under a pixel wide: through a pixel's centre, past it, or past it by a hair.
void add_specks(Trials& trials, Random& random) {
    for (const NamedCamera& each : cameras()) {
        const PictureSize size = sizes[random.bits() % sizes.size()];
        Trial trial{named("under a pixel wide, camera " + each.name) + of_size(size), {}, size};
        const Camera& camera = trial.scene.camera = each.camera;
        for (int count = 0; count < 600; ++count) {
            const glm::dvec3 ray = direction(camera, size, pixel_at_border(size, random));
            const double depth = random.of_size(0.5, 8.0);
            const double radius = random.of_size(1e-9, 0.4) * 2.0 * glm::length(camera.right) / size.shorter_side() * depth;
            const glm::dvec3 side = glm::normalize(glm::cross(ray, random.in_cube(1.0)));
            const double off = random.chance(0.3) ? 0.0 : random.chance(0.5) ? radius : radius * random.of_size(0.5, 2.0);
            trial.scene.spheres.push_back({camera.eye + depth * ray + off * side, radius, blue});
        }
        trials.push_back(trial);
    }
    // The default camera's rays to the pixels of 25 x 25 are the whole vectors (k, l, 25): spheres with their centres on them,
    // and some that touch the rays (0, l, 25) and (k, 0, 25) from the side.
    Trial whole{named("under a pixel wide, exactly on pixels' centres"), {}, {25, 25}};
    for (int k = -12; k <= 12; ++k) {
        for (int l = -12; l <= 12; ++l) {
            const double radius = std::ldexp(1.0, random.whole(-40, -2));
            glm::dvec3 center = std::ldexp(1.0, random.whole(0, 4)) * glm::dvec3(k, l, 25);
            if (k == 0 && l % 2 == 0) center.x += radius;
            if (l == 0 && k % 2 == 0) center.y -= radius;
            whole.scene.spheres.push_back({center, radius, blue});
        }
    }
    trials.push_back(whole);
}

// Vectors of whole numbers with a whole length (the last component).
glm::dvec4 whole_length(int most, Random& random) {
    const double m = random.whole(1, most);
    const double n = random.whole(-most, most);
    const double p = random.whole(-most, most);
    const double q = random.whole(-most, most);
    return {2.0 * (m * q + n * p), 2.0 * (n * q - m * p), m * m + n * n - p * p - q * q, m * m + n * n + p * p + q * q};
}

// All begin exactly as far from the eye (or end, from inside): a walk in order of distance has nothing to go by.
void add_shells(Trials& trials, Random& random) {
    const glm::dvec3 eye(3, -5, 0.5);
    std::vector<Sphere> equal;
    constexpr int distance = 225;  // there are many whole vectors of this length
    for (int x = -distance; x <= distance; ++x) {
        for (int y = -distance; y <= distance; ++y) {
            const int square = distance * distance - x * x - y * y;
            const int z = static_cast<int>(std::lround(std::sqrt(std::max(0, square))));
            if (z * z != square) continue;
            equal.push_back({eye + glm::dvec3(x, y, z), 40.0, blue});
            if (random.chance(0.1)) equal.push_back({eye + glm::dvec3(x, y, -z), 40.0, blue});
        }
    }
    for (const PictureSize size : {PictureSize{33, 35}, {67, 19}, {129, 9}}) {
        Scene scene;
        scene.camera.eye = eye;
        scene.camera.center = eye + glm::dvec3(0, 0, 60);
        scene.spheres = equal;
        trials.push_back({named("a shell of equal spheres around the eye") + of_size(size), scene, size});
        for (const bool inside : {false, true}) {
            scene.spheres.clear();
            for (int count = 0; count < 300; ++count) {
                glm::dvec4 v = whole_length(7, random);
                if (count % 8 != 0) v.z = std::fabs(v.z);
                v *= inside ? random.whole(1, 3) : std::ceil(110.0 / v.w) * random.whole(1, 9);
                scene.spheres.push_back({eye + glm::dvec3(v), inside ? v.w + 300.0 : v.w - 100.0, blue});
            }
            const char* kind = inside ? "insides that are equally far" : "spheres that are equally near";
            trials.push_back({named(kind) + of_size(size), scene, size});
        }
    }
}

// Larger than the picture, one through another, the eye inside of some.
void add_giants(Trials& trials, Random& random) {
    for (const NamedCamera& each : cameras()) {
        const PictureSize size = sizes[random.bits() % sizes.size()];
        Trial trial{named("larger than the picture, camera " + each.name) + of_size(size), {}, size};
        const Camera& camera = trial.scene.camera = each.camera;
        for (int count = 0; count < 60; ++count) {
            const glm::dvec3 v = random.of_size(10.0, 1e7) * random.in_cube(1.0);
            const double distance = glm::length(v);
            trial.scene.spheres.push_back({camera.eye + v, std::fabs(distance + random.between(-300.0, 100.0)) + 0.5, blue});
        }
        trials.push_back(trial);
    }
}

// Across the plane through the eye that is parallel to the screen, at every angle; also touching that plane.
void add_eye_plane(Trials& trials, Random& random) {
    constexpr int angles = 16;
    for (const NamedCamera& each : cameras()) {
        const PictureSize size = sizes[random.bits() % sizes.size()];
        Trial all{named("across the eye's plane, camera " + each.name) + of_size(size), {}, size};
        const Camera& camera = all.scene.camera = each.camera;
        const double edge = glm::length(camera.right);
        const glm::dvec3 right = camera.right / edge;
        const glm::dvec3 up = camera.up / glm::length(camera.up);
        glm::dvec3 view = glm::normalize(glm::cross(right, up));
        if (glm::dot(view, camera.center - camera.eye) < 0.0) view = -view;
        for (int count = 0; count < 4 * angles; ++count) {
            const double angle = 6.283185307179586 * count / angles;
            const double off = edge * random.of_size(0.01, 100.0);
            const double radius = off * random.between(0.3, 1.02);
            const double parts[] = {0.0, 1.0, -1.0, random.between(-1.0, 1.0), random.between(0.9, 1.1), random.between(0.0, 0.2)};
            const double depth = radius * parts[random.whole(0, 5)];
            const glm::dvec3 center = camera.eye + off * (std::cos(angle) * right + std::sin(angle) * up) + depth * view;
            all.scene.spheres.push_back({center, nudged(radius, random), blue});
            if (count % 5 != 0) continue;
            Trial alone = all;
            alone.name = named("one across the eye's plane, camera " + each.name) + of_size(size);
            alone.scene.spheres = {all.scene.spheres.back()};
            trials.push_back(alone);
        }
        trials.push_back(all);
    }
}

// Ordinary spheres and one that floats cannot hold: it is in the lists of all tiles.
void add_beyond_float(Trials& trials, Random& random) {
    const std::vector<Sphere> strange = {{{1e-300, 0, 1e-300}, 1e-300, blue}, {{0, 0, 2e-300}, 1e-300, blue},
                                         {{0, 0, 1e200}, 1e200, blue},        {{1e200, 0, 1e200}, 1.1e200, blue},
                                         {{0, 0, -1e200}, 1e199, blue},       {{0, 5, 1e-9}, 1e200, blue}};
    for (const Sphere& one : strange) {
        Trial trial{named("one sphere beyond float"), {}, {35, 9}};
        for (int count = 0; count < 12; ++count) {
            const double z = random.between(120.0, 400.0);
            const glm::dvec3 center(random.between(-2.0, 2.0) * z, random.between(-0.5, 0.5) * z, z);
            trial.scene.spheres.push_back({center, random.between(5.0, 60.0), blue});
        }
        trial.scene.spheres.insert(trial.scene.spheres.begin() + random.whole(0, 12), one);
        trials.push_back(trial);
    }
}

}  // namespace

Trial crowded_tiles_trial(PictureSize size, int small, int huge) {
    Random random(seed() + static_cast<std::uint64_t>(small));
    Trial trial{named(std::to_string(small) + " small and " + std::to_string(huge) + " huge spheres") + of_size(size), {}, size};
    const Camera& camera = trial.scene.camera = turned({40, 7, -90}, {1, -1, 3}, 0.4, 100.0, 70.0);
    for (int i = 0; i < small + huge; ++i) {
        const Pixel pixel{random.whole(-3, size.width + 2), random.whole(-3, size.height + 2)};
        const double depth = random.of_size(0.3, 9.0) * (random.chance(0.05) ? -1.0 : 1.0);
        const glm::dvec3 center = camera.eye + depth * direction(camera, size, pixel);
        // Small enough that long lists are walked, which calls for fine tiles; the huge ones behind them go to coarser ones.
        const double pixel_side = 140.0 / size.shorter_side() * std::fabs(depth);
        const double radius = pixel_side * (i < small ? random.of_size(0.01, 0.4) : random.of_size(5.0, 1000.0));
        trial.scene.spheres.push_back({i < small ? center : camera.eye + 4.0 * (center - camera.eye), radius, blue});
    }
    return trial;
}

Trials tile_trials() {
    Trials trials;
    Random random(seed() + 8);
    add_exact_tangents(trials, random);
    add_near_tangents(trials, random);
    add_specks(trials, random);
    add_shells(trials, random);
    add_giants(trials, random);
    add_eye_plane(trials, random);
    add_beyond_float(trials, random);
    trials.push_back(crowded_tiles_trial({31, 20}, 4000, 4));
    trials.push_back(crowded_tiles_trial({101, 6}, 3000, 20));
    return trials;
}

}  // namespace sphereview::oracle

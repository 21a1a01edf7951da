// Rays that touch spheres, spheres that touch each other, the eye on surfaces: exactly, and one unit in the last place off.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "oracle/scenes.hpp"
#include "support/spheres.hpp"

namespace sphereview::oracle {

namespace {

constexpr Color red{255, 0, 0};

double above(double value) { return std::nextafter(value, HUGE_VAL); }
double below(double value) { return std::nextafter(value, -HUGE_VAL); }

Sphere red_sphere(double x, double y, double z, double radius) { return {{x, y, z}, radius, red}; }

// The default camera with 25 pixels to the side: pixel rays are the whole vectors (k, l, 25), -12 <= k, l <= 12.
constexpr PictureSize whole_rays{25, 25};

// Of odd pictures the central ray is the axis; it touches spheres beside it.
void add_axis_tangents(Trials& trials) {
    for (const PictureSize size : {PictureSize{1, 1}, {63, 63}, {33, 7}, {7, 33}, {1, 63}, {63, 1}, {101, 3}}) {
        for (const double r : {0.1, 20.0, 1e-5, 1.0 / 3.0, 4096.0}) {
            const Sphere behind = red_sphere(0, 0, 500, 40);
            trials.push_back(
                {"the axis touches a sphere", scene_of({behind, red_sphere(r, 0, 300, r), red_sphere(0, -r, 300, r)}), size});
            trials.push_back(
                {"the axis is a hair's breadth inside and outside",
                 scene_of({behind, red_sphere(0, r, 300, below(r)), red_sphere(-r, 0, 310, above(r)), red_sphere(0, r, 320, r)}),
                 size});
        }
    }
}

// A whole vector of whole length, perpendicular to v, which makes a sphere of whole radius touch the ray along v.
bool find_perpendicular(const glm::dvec3& v, int skip, glm::dvec3& found, double& length) {
    constexpr int most = 12;
    for (int x = -most; x <= most; ++x) {
        for (int y = -most; y <= most; ++y) {
            const double wanted = -(x * v.x + y * v.y) / v.z;
            if (wanted != std::floor(wanted) || std::fabs(wanted) > most) continue;
            const double square = x * x + y * y + wanted * wanted;
            length = std::round(std::sqrt(square));
            if (square == 0.0 || length * length != square || skip-- > 0) continue;
            found = {x, y, wanted};
            return true;
        }
    }
    return false;
}

void add_pythagorean_tangents(Trials& trials) {
    for (int variant = 0; variant < 12; ++variant) {
        Scene alone;
        Scene tied;  // each with a second sphere that touches the ray at the same point, or lets it in there
        for (int k = -12; k <= 12; ++k) {
            for (int l = -12; l <= 12; ++l) {
                const glm::dvec3 ray(k, l, 25);
                glm::dvec3 side;
                double length = 0.0;
                if ((k + 2 * l + 40) % 4 != variant % 4 || !find_perpendicular(ray, variant, side, length)) continue;
                const double far = 6.0 + (k * 5 + l * 3 + 120) % 7;
                const double part = 1.0 / (1 << (3 + variant % 3));
                alone.spheres.push_back({far * ray + part * side, part * length, red});
                tied.spheres.push_back(alone.spheres.back());
                tied.spheres.push_back({far * ray - 2.0 * part * side, 2.0 * part * length, red});
                if (k % 3 == 0) tied.spheres.push_back({far * ray + glm::dvec3(2, 3, 6), 7.0, red});
            }
        }
        const std::string name = "tangents at many pixels " + std::to_string(variant);
        trials.push_back({name, alone, whole_rays});
        trials.push_back({name + ", tied", tied, whole_rays});
        std::reverse(tied.spheres.begin(), tied.spheres.end());
        trials.push_back({name + ", tied, in reverse", tied, whole_rays});
    }
}

// v mirrored in the plane through the eye that is perpendicular to n; exact for the whole numbers used here.
glm::dvec3 mirrored(const glm::dvec3& v, const glm::dvec3& n) { return v - 2.0 * glm::dot(v, n) / glm::dot(n, n) * n; }

// Two spheres that mirror each other are equally far on every ray in the mirror.
void add_mirrored_pairs(Trials& trials) {
    const std::vector<Sphere> originals = {red_sphere(26, 13, 260, 52), red_sphere(52, 0, 520, 91), red_sphere(13, -26, 390, 390),
                                           red_sphere(0, 26, 0, 78),    red_sphere(78, 26, 26, 91), red_sphere(6.5, 13, 130, 26)};
    for (const glm::dvec3& mirror : {glm::dvec3(1, 0, 0), {0, 1, 0}, {1, 1, 0}, {1, -1, 0}, {3, 4, -1}, {-1, 0, 5}, {5, 0, 1}}) {
        for (int order = 0; order < 4; ++order) {
            Scene scene;
            for (const Sphere& original : originals) {
                scene.spheres.push_back(original);
                scene.spheres.push_back({mirrored(original.center, mirror), original.radius, red});
                if (order == 3) scene.spheres.back().radius = above(original.radius);
            }
            if (order == 1) std::reverse(scene.spheres.begin(), scene.spheres.end());
            if (order == 2) std::rotate(scene.spheres.begin(), scene.spheres.begin() + 5, scene.spheres.end());
            trials.push_back({"mirrored pairs " + std::to_string(order), scene, order % 2 == 0 ? whole_rays : PictureSize{51, 51}});
        }
    }
}

// All four kinds of root at the same point of the axis, in every order of the file and with single bits changed.
void add_ties_of_all_kinds(Trials& trials) {
    std::vector<Sphere> kinds = {red_sphere(0, 0, 0, 200), red_sphere(0, 0, 250, 50), red_sphere(0, 0, 100, 100),
                                 red_sphere(50, 0, 200, 50)};
    std::vector<int> order = {0, 1, 2, 3};
    do {
        Scene scene;
        for (const int kind : order) scene.spheres.push_back(kinds[static_cast<std::size_t>(kind)]);
        trials.push_back({"an inner, an outer, a surface and a tangent root tie", scene, {5, 3}});
        for (std::size_t i = 0; i < 4; ++i) {
            for (const bool up : {false, true}) {
                Scene changed = scene;
                changed.spheres[i].radius = up ? above(scene.spheres[i].radius) : below(scene.spheres[i].radius);
                trials.push_back({"nearly tied roots of all kinds", changed, {3, 5}});
            }
        }
    } while (std::next_permutation(order.begin(), order.end()));
}

void add_ulp_depths(Trials& trials) {
    for (const double z : {200.0, 100.1, 1e6, 3.3}) {
        Scene depths;
        Scene radii;
        double depth = z;
        double radius = 0.4 * z;
        for (int i = 0; i < 6; ++i) {
            depths.spheres.insert(depths.spheres.begin(), red_sphere(0.1, -0.2, depth, 0.4 * z));
            radii.spheres.push_back(red_sphere(0.1, -0.2, z, radius));
            depth = above(depth);
            radius = above(radius);
        }
        trials.push_back({"depths one unit in the last place apart", depths, {23, 21}});
        trials.push_back({"radii one unit in the last place apart", radii, {23, 21}});
        std::swap(depths.spheres[1], depths.spheres[5]);
        depths.spheres.push_back(depths.spheres[5]);
        trials.push_back({"depths one unit apart, shuffled", depths, {22, 20}});
        for (Sphere& each : radii.spheres) each.center = {0.0, 0.0, 0.0};
        trials.push_back({"the same from inside", radii, {22, 20}});
    }
}

void add_eyes_on_surfaces(Trials& trials) {
    // x^2 + y^2 + z^2 = r^2 in whole numbers.
    const std::vector<glm::dvec4> quadruples = {{2, 3, 6, 7},    {1, 4, 8, 9}, {2, 6, 9, 11},  {6, 6, 7, 11}, {0, 3, 4, 5},
                                                {12, 9, 20, 25}, {0, 0, 1, 1}, {8, 9, 12, 17}, {3, 4, 0, 5},  {4, 13, 16, 21}};
    for (const glm::dvec3& eye : {glm::dvec3(0.0), glm::dvec3(3, -5, 7), glm::dvec3(0x1p40, 0.5, -0x1p30)}) {
        for (int variant = 0; variant < 6; ++variant) {
            Scene scene;
            for (std::size_t i = 0; i < quadruples.size(); ++i) {
                const glm::dvec4 q = quadruples[i] * (variant == 5 ? 0x1p-12 : 4.0);
                const double sign = (i + static_cast<std::size_t>(variant)) % 3 == 0 ? -1.0 : 1.0;
                const glm::dvec3 at(sign * q.x, i % 2 == 0 ? q.y : -q.y, variant == 4 ? -q.z : q.z);
                const double r = variant == 1 ? above(q.w) : variant == 2 ? below(q.w) : q.w;
                if (variant != 3 || i % 2 == 0) scene.spheres.push_back({eye + at, r, red});
                if (variant == 3) scene.spheres.push_back({eye + glm::dvec3(at.y, at.x, at.z), r, red});
            }
            scene.camera.eye = eye;
            scene.camera.center = eye + glm::dvec3(0, 0, 100);
            trials.push_back({"the eye on surfaces " + std::to_string(variant), scene, {25, 25}});
        }
    }
    // At the left the larger is hit right before the eye, and the smaller behind that.
    trials.push_back({"the eye on a surface before a nearer centre",
                      scene_of({red_sphere(8, 0, 6, 10), red_sphere(-2.6, 0, 5.37, 0.5)}),
                      {25, 25}});
}

void add_insides(Trials& trials) {
    Scene nested;
    for (const double r : {300.0, 10.0, 150.0, 10.000000000000002, 1e-300, 5e-324, 1e200, 0.1})
        nested.spheres.push_back(red_sphere(0, 0, 0, r));
    trials.push_back({"the eye at the centre of nested spheres", nested, {31, 17}});
    Scene touching;  // from inside, at one point of the axis
    for (const double r : {100.0, 50.0, 25.0, 12.5, 150.0}) touching.spheres.push_back(red_sphere(0, 0, 300 - r, r));
    trials.push_back({"nested spheres that touch at their far ends", touching, {31, 31}});
    for (Sphere& each : touching.spheres) each.center.z = 100 + each.radius;
    trials.push_back({"nested spheres that touch at their near ends", touching, {31, 31}});
    for (Sphere& each : touching.spheres) each.center.z = 200 - each.radius;
    trials.push_back({"nested spheres around and before the eye that touch", touching, {31, 31}});
    Scene plane;  // through the plane z = 0 of the eye
    plane.spheres = {red_sphere(20, 0, 10, 15), red_sphere(-20, 5, -3, 15),     red_sphere(0, 30, 0, 29),
                     red_sphere(0, -30, 0, 30), red_sphere(0, 0, -50, 50),      red_sphere(0, 0, -50, above(50)),
                     red_sphere(0, 0, -50, 49), red_sphere(1e6, 0, 1, 1e6 - 1), red_sphere(0, 1e9, -1, 1e9 - 4)};
    for (const PictureSize size : {PictureSize{64, 64}, {63, 61}, {101, 11}})
        trials.push_back({"across the eye's plane", plane, size});
    for (const Sphere& each : plane.spheres) trials.push_back({"across the eye's plane, one", scene_of({each}), {33, 31}});
}

}  // namespace

Trials touching_trials() {
    Trials trials;
    add_axis_tangents(trials);
    add_pythagorean_tangents(trials);
    add_mirrored_pairs(trials);
    add_ties_of_all_kinds(trials);
    add_ulp_depths(trials);
    add_eyes_on_surfaces(trials);
    add_insides(trials);
    return trials;
}

}  // namespace sphereview::oracle

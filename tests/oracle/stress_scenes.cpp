// Thousands of spheres between which double cannot choose at most pixels: how much exact work there is must stay bounded.
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <utility>

#include "oracle/scenes.hpp"

namespace sphereview::oracle {

namespace {

double ulps(double value, double count) { return value + count * (std::nextafter(value, HUGE_VAL) - value); }

// Spheres that meet in one circle around (0, 0, 200): their centres lie on the axis of the circle, so that r^2 - x^2 = circle^2 for
// the distance x from its centre. All tie where a ray runs in the plane of the circle.
std::vector<Sphere> pencil(int count, const glm::dvec3& axis, double scale) {
    constexpr std::int64_t circle = 232'792'560;  // has many divisors
    std::vector<std::int64_t> divisors = {1};     // of its square
    for (const auto& [prime, most] :
         std::initializer_list<std::pair<int, int>>{{2, 8}, {3, 4}, {5, 2}, {7, 2}, {11, 2}, {13, 2}, {17, 2}, {19, 2}}) {
        const std::size_t smaller = divisors.size();
        std::int64_t power = 1;
        for (int i = 0; i < most; ++i) {
            power *= prime;
            for (std::size_t k = 0; k < smaller; ++k) divisors.push_back(divisors[k] * power);
        }
    }
    std::erase_if(divisors, [](std::int64_t d) { return d >= circle || d % 2 != 0; });
    std::ranges::sort(divisors, std::greater());
    std::vector<Sphere> spheres;
    // (r - x)(r + x) = circle^2
    for (const std::int64_t d : divisors) {
        const std::int64_t other = circle * circle / d;
        if (other % 2 != 0 || static_cast<int>(spheres.size()) == count) continue;
        const auto x = static_cast<double>((other - d) / 2) * scale * (spheres.size() % 2 == 0 ? 1.0 : -1.0);
        spheres.push_back(
            {glm::dvec3(0, 0, 200) + x * axis, static_cast<double>((other + d) / 2) * scale * std::round(glm::length(axis))});
    }
    return spheres;
}

// All of a whole radius and with whole centres, tangent to rays that 25 x 25, 75 x 75 or 225 x 225 pixels have.
std::vector<Sphere> tangent(int count) {
    std::vector<Sphere> spheres;
    for (int i = 0; i < count; ++i) {
        const double far = 4.0 + i;
        spheres.push_back({glm::dvec3(0, 0, 25) * far + glm::dvec3(2.0 + i % 3, 0, 0), 2.0 + i % 3});
    }
    return spheres;
}

}  // namespace

Trials stress_trials(int count, PictureSize size) {
    Trials trials;
    const auto add = [&](const std::string& name, const std::function<Sphere(double)>& sphere) {
        Trial trial{"stress: " + name, {}, size};
        for (int i = 0; i < count; ++i) trial.scene.spheres.push_back(sphere(i));
        trials.push_back(trial);
    };
    const auto add_spheres = [&](const std::string& name, std::vector<Sphere> spheres) {
        trials.push_back({"stress: " + name, {}, size});
        trials.back().scene.spheres = std::move(spheres);
    };
    const double n = count;
    add("very far", [](double i) { return Sphere{{0, 0, 1e300 * (i + 1)}, 1e305}; });
    add("very far, and small ones before them", [](double i) {
        if (std::fmod(i, 2) == 0) return Sphere{{0, 0, 1e300 * (i + 1)}, 1e305};
        return Sphere{{std::fmod(i * 37, 200) - 100, std::fmod(i * 61, 200) - 100, 150 + std::fmod(i, 100)}, 1};
    });
    add("far, through nearly one point", [](double i) { return Sphere{{0, 0, 1e15 + i}, 1e15 + i - 100}; });
    add("far, through nearly one point, the nearest last", [=](double i) {
        return Sphere{{0, 0, 1e15 + (n - i) / 8}, 1e15 + (n - i) / 8 - 100};
    });
    add("very far, through nearly one point", [](double i) {
        return Sphere{{0, 0, (1e15 + i) * 0x1p900}, (1e15 + i - 100) * 0x1p900};
    });
    add("far to the side, through nearly one point", [](double i) { return Sphere{{1e15 + i, 0, 100}, 1e15 + i - 10}; });
    add("radii one unit apart", [](double i) { return Sphere{{0, 0, 200}, ulps(130, i)}; });
    add("radii one unit apart, from inside", [](double i) { return Sphere{{0, 0, 200}, ulps(300, i)}; });
    add("depths one unit apart", [=](double i) { return Sphere{{0, 0, ulps(200, n - i)}, 130}; });
    add("centres and radii some units apart", [](double i) {
        return Sphere{{ulps(30, std::fmod(i * 7, 17)), ulps(-40, std::fmod(i * 5, 13)), ulps(200, std::fmod(i * 3, 11))},
                      ulps(100, std::fmod(i, 19))};
    });
    add("one cone around all", [](double i) {
        const double s = 1 + i / 5000;
        return Sphere{{30 * s, 40 * s, 200 * s}, 25 * s};
    });
    add("giants that touch the planes of pixel columns", [=](double i) {
        const double column = std::fmod(i, size.width);
        const double a = (2 * column + 1 - size.width) / size.shorter_side() * 50;
        const double length = std::hypot(a, 100);
        const double r = ulps(std::pow(10, 15 + std::fmod(std::floor(i / size.width), 6)), i);
        return Sphere{{100 / length * r + 3 * a, 0, -a / length * r + 300}, r};
    });
    add_spheres("tangent to the same rays", tangent(count));
    add_spheres("a pencil", pencil(count, {1, 0, 0}, 0x1p-21));
    add_spheres("a pencil, tilted", pencil(count, {3, 4, 0}, 0x1p-23));
    // Seen from elsewhere: differences from the eye are not doubles.
    const std::size_t seen_from_0 = trials.size();
    for (std::size_t i = 2; i < seen_from_0; i += 3) {
        Trial moved = trials[i];
        moved.name += ", from elsewhere";
        moved.scene.camera.eye = {0.1, -0.2, 0.3};
        moved.scene.camera.center = {0.1, -0.2, 100.3};
        trials.push_back(moved);
    }
    for (std::size_t i = 0; i < seen_from_0; i += 4) {
        Trial reversed = trials[i];
        reversed.name += ", in reverse";
        std::ranges::reverse(reversed.scene.spheres);
        trials.push_back(reversed);
    }
    // Magnitudes that no one scale holds.
    const glm::dvec3 tiny_step{0, 0, 1e-320};
    add("small beside large within one sphere", [](double i) { return Sphere{{1e-300, 0, 2e305}, ulps(1e305, i)}; });
    trials.back().scene.camera.eye = tiny_step;
    add("apart by what their scale does not hold", [](double i) { return Sphere{{1e-300 * (i + 1), 0, 2e305}, 1e305}; });
    trials.back().scene.camera.eye = tiny_step;
    add("apart by the smallest numbers", [](double i) { return Sphere{{1e-322 * (i + 1), 0, 2e5}, 1e5}; });
    add("far, and one unit apart across", [](double i) { return Sphere{{ulps(1, i), 0, 3.1e15}, 1.2345e15}; });
    add("tiny ones in a giant", [](double i) {
        return i == 0 ? Sphere{{0, 0, 0}, 1e305} : Sphere{{0, 0, 200e-300}, ulps(130e-300, i)};
    });
    add("tiny ones before giants", [](double i) {
        if (std::fmod(i, 2) == 0) return Sphere{{0, 0, 200e-300}, ulps(60e-300, i)};
        return Sphere{{0, 0, 1e300 * (i + 1)}, 1e305};
    });
    add("of all sizes, from one cone", [=](double i) {
        const double scale = std::ldexp(1.0, static_cast<int>(i * 2000 / n) - 1000);
        return Sphere{{0, 0, 3 * scale}, 1.5 * scale};
    });
    add("around one point, from there", [](double i) { return Sphere{{1e10, 1, 1}, 1e-300 * (i + 1)}; });
    trials.back().scene.camera.eye = {1e10, 1, 1};
    trials.back().scene.camera.center = {1e10, 1, 101};
    add("from beside a screen that is far too near", [](double i) { return Sphere{{0, 0, 200}, ulps(130, i)}; });
    trials.back().scene.camera.center = {0, 0, 1e-305};
    add("small ones from beside a screen that is far too near", [](double i) { return Sphere{{0, 0, 200}, 1e-3 * (i + 1)}; });
    trials.back().scene.camera.center = {0, 0, 1e-305};
    // Before and behind the plane that parallel rays begin in.
    add("far to one side, through nearly one point", [](double i) {
        const glm::dvec3 center{1e15 + i / 8, 3e14, 1e15 - i / 8};
        return Sphere{center, glm::length(center) - 100};
    });
    trials.push_back(orthographic(trials.back()));
    return trials;
}

}  // namespace sphereview::oracle

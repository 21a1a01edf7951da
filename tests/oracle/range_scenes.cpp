// Numbers at the ends of what a double holds, and pictures at the ends of what a picture is.
#include <cmath>
#include <limits>

#include "oracle/scenes.hpp"

namespace sphereview::oracle {

namespace {

constexpr Color green{0, 255, 0};
constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double largest = std::numeric_limits<double>::max();

Sphere sphere(double x, double y, double z, double radius) { return {{x, y, z}, radius, green}; }

Camera looking(double distance, double edge) { return {{0, 0, 0}, {0, 0, distance}, {edge, 0, 0}, {0, edge, 0}}; }

Camera scaled(const Camera& camera, double scale) {
    return {camera.eye * scale, camera.center * scale, camera.right * scale, camera.up * scale};
}

void add(Trials& trials, const std::string& name, const Camera& camera, std::vector<Sphere> spheres, PictureSize size = {15, 13}) {
    Scene scene;
    scene.camera = camera;
    scene.spheres = std::move(spheres);
    trials.push_back({name, scene, size});
}

void add_radii(Trials& trials) {
    std::vector<Sphere> all;
    for (const double r : {1e-300, 1e-160, 1e-45, 1e-20, 1e-10, 1e-3, 1.0, 1e10, 1e19, 1e20, 1e40, 1e150, 1e160, 1e200}) {
        const std::vector<Sphere> around = {sphere(0, 0, 200, r), sphere(5, 5, 100, 2), sphere(-3, 0, 110, 3)};
        add(trials, "a radius of " + std::to_string(std::log10(r)) + " digits", {}, around, {21, 21});
        all.push_back(sphere(0, 0, r < 100 ? 100 : 1.5 * r, r));
        all.push_back(sphere(r, 0, 0, r));
        all.push_back(sphere(0, r, 100, r));
    }
    add(trials, "radii of all sizes", {}, all);
    add(trials, "the surface of a huge sphere at the eye", {},
        {sphere(0, 0, 1e200, 1e200), sphere(0, 0, 100, 20), sphere(0, 0, -1e200, 1e200),
         sphere(1e200, 0, 0, std::nextafter(1e200, 0))});
}

// One scene at every scale, also where squares overflow or everything is subnormal.
void add_scales(Trials& trials) {
    const std::vector<Sphere> spheres = {sphere(0, 0, 200, 20),    sphere(20, 0, 200, 20), sphere(0, 50, 300, 50),
                                         sphere(-16, -16, 64, 8),  sphere(48, 64, 0, 80),  sphere(0, 0, 0, 512),
                                         sphere(-16, -16, 128, 16)};
    for (const int exponent :
         {-1074, -1073, -1070, -1040, -1022, -900, -540, -512, -300, -160, -150, -140, -127, -64, -41, -40, -39, -38, -37, -36, -35,
          -34,   0,     20,    40,    50,    51,   52,   53,   54,   55,   56,   60,   64,   120, 128, 300, 500, 512, 900, 1010}) {
        const double scale = std::ldexp(1.0, exponent);
        std::vector<Sphere> at_scale = spheres;
        for (Sphere& each : at_scale) each = {each.center * scale, each.radius * scale, each.color};
        const std::string name = "all at the scale 2^" + std::to_string(exponent);
        add(trials, name, scaled({}, scale), at_scale);
        add(trials, name + ", seen by the default camera", {}, at_scale);
        std::vector<Sphere> mixed = spheres;
        mixed.insert(mixed.end(), at_scale.begin(), at_scale.end());
        add(trials, name + ", and at 1", {}, mixed, {11, 9});
        add(trials, name + ", only the camera", scaled({}, scale), spheres);
        Camera away;
        away.eye = {200, 0, 0};
        away.center = {300, 0, 0};
        away.right = {0, 0, 50};
        add(trials, name + ", seen from the side", scaled(away, scale), at_scale);
    }
}

void add_extremes(Trials& trials) {
    add(trials, "the least camera", looking(smallest, smallest),
        {sphere(0, 0, 1, 0.5), sphere(0.5, 0, 2, 1), sphere(0, 0, 3e-324, 5e-324)});
    add(trials, "the least everything", looking(8 * smallest, 8 * smallest),
        {sphere(0, 0, smallest, smallest), sphere(0, smallest, 3 * smallest, smallest), sphere(2 * smallest, 0, 0, smallest),
         sphere(0, 0, 5 * smallest, 5 * smallest), sphere(0, 0, 0, 9 * smallest)});
    add(trials, "the largest everything", looking(largest, largest / 2),
        {sphere(0, 0, largest, largest / 4), sphere(largest, 0, largest, largest / 2), sphere(0, -largest, largest, largest),
         sphere(0, 0, -largest, largest), sphere(0, 0, largest / 2, largest)});
    Camera across{{0, 0, -largest}, {0, 0, largest}, {largest, 0, 0}, {0, largest, 0}};
    add(trials, "differences that overflow", across,
        {sphere(0, 0, largest, largest), sphere(1e308, 0, 1e308, 1e308), sphere(0, 0, 0, 1)});
    across.eye = {largest, largest, -largest};
    add(trials, "differences that overflow, aslant", across,
        {sphere(-largest, -largest, largest, largest), sphere(0, 0, 0, largest)});
    add(trials, "tiny beside huge", {},
        {sphere(1e-310, 0, 1e300, 1e299), sphere(0, 0, 100, 5e-324), sphere(5e-324, 1e-310, 1e-308, 1e-308)});
    add(trials, "a wide screen at once before the eye", looking(1e-300, 1), {sphere(0, 0, 100, 20), sphere(100, 0, 0, 20)});
    add(trials, "a wide screen before the eye", looking(1e-12, 1),
        {sphere(0, 0, 100, 20), sphere(100, 0, 1e-10, 20), sphere(-9, 0, 0, 8)});
    add(trials, "a narrow screen far away", looking(1e30, 1), {sphere(0, 0, 1e31, 1), sphere(1, 1, 1e31, 1.5)}, {9, 9});
    add(trials, "minus zero", {{-0.0, 0.0, -0.0}, {-0.0, -0.0, 100}, {50, -0.0, 0}, {-0.0, 50, -0.0}},
        {sphere(-0.0, 0, 200, 20), sphere(0, -0.0, 200, 20), sphere(0, 0, -0.0, 300), sphere(-0.0, -0.0, 0, 300)});
}

void add_far_eyes(Trials& trials) {
    for (const double far : {1e6, 1e10, 1e15}) {
        Camera camera;
        camera.eye = {far, -far, far};
        camera.center = camera.eye + glm::dvec3(0, 0, 100);
        std::vector<Sphere> spheres;
        for (int i = 0; i < 30; ++i)
            spheres.push_back({camera.eye + glm::dvec3(i % 5 - 2, i % 7 - 3, 4 + i % 3), 0.3 + 0.01 * i, green});
        add(trials, "a far eye before small spheres", camera, spheres, {41, 39});
        spheres.push_back(sphere(0, 0, 0, std::sqrt(3.0) * far));
        add(trials, "a far eye nearly on a large sphere", camera, spheres, {41, 39});
    }
}

// The screen's centre far off the axis: rays lose digits, up to and beyond what the filters take.
void add_far_screens(Trials& trials) {
    for (const double shift : {50.0, 1e3, 1.03e4, 1.04e4, 1.05e4, 1.06e4, 1.07e4, 1e5, 1e6, 9e7}) {
        Camera camera;
        camera.center = {shift, -0.3 * shift, 100};
        camera.right = {0.6 * shift, 0, 0};
        camera.up = {0, 0.6 * shift, 0};
        std::vector<Sphere> spheres;
        for (int i = 0; i < 24; ++i) {
            const glm::dvec3 toward = camera.center + (i % 5 - 2) * 0.4 * camera.right + (i % 4 - 1.5) * 0.5 * camera.up;
            spheres.push_back({(1.0 + 0.1 * i) * toward, (0.02 + 0.003 * i) * shift, green});
            if (i % 3 == 0) spheres.push_back({(1.0 + 0.1 * i) * toward, (0.02 + 0.003 * i) * shift * (1 + 1e-14), green});
        }
        add(trials, "a screen off the axis", camera, spheres, {37, 35});
    }
}

void add_odd_pictures(Trials& trials) {
    std::vector<Sphere> row;
    for (int i = -20; i <= 20; ++i) row.push_back(sphere(8 * i, i % 3, 200 + i % 7, 5 + 0.1 * (i + 20)));
    for (const PictureSize size :
         {PictureSize{1, 1}, {2, 1}, {1, 2}, {1, 300}, {300, 1}, {1023, 2}, {3, 511}, {127, 5}, {129, 5}, {64, 64}}) {
        add(trials, "an odd picture", {}, row, size);
        add(trials, "nothing to see", {}, {}, size);
    }
    add(trials, "nothing to see from afar", scaled({}, 1e300), {});
    std::vector<Sphere> copies;
    for (int i = 0; i < 300; ++i) copies.push_back(sphere(i % 2 == 0 ? 0.0 : -0.0, 0, 200, 30));
    copies.insert(copies.begin() + 100, sphere(0, 0, 200.00000000000003, 30));
    copies.insert(copies.begin(), sphere(0, 0, 300, 90));
    add(trials, "copies", {}, copies, {31, 31});
    for (std::size_t i = 0; i < copies.size(); i += 3) copies[i].hidden = true;
    copies[1].hidden = true;
    add(trials, "hidden copies", {}, copies, {31, 31});
    for (Sphere& each : copies) each.hidden = true;
    add(trials, "all hidden", {}, copies);
}

}  // namespace

Trials range_trials() {
    Trials trials;
    add_radii(trials);
    add_scales(trials);
    add_extremes(trials);
    add_far_eyes(trials);
    add_far_screens(trials);
    add_odd_pictures(trials);
    return trials;
}

}  // namespace sphereview::oracle

#include "viewer/window_icon.hpp"

#include "app/render_picture.hpp"
#include "base/timings.hpp"
#include "exact/drawn.hpp"

namespace sphereview {

Scene icon_scene() {
    Scene scene;
    scene.background = {{}, true};
    scene.camera = {{0.0, 0.0, -20000.0}, {0.0, 0.0, -100.0}, {63.68, 0.0, 0.0}, {0.0, 63.68, 0.0}};
    scene.spheres = {{{4.0, -6.0, 40.0}, 50.0, {110, 175, 255}},
                     {{-36.0, 30.0, -30.0}, 26.0, {255, 80, 72}},
                     {{30.0, -34.0, -50.0}, 21.0, {250, 196, 44}},
                     {{42.0, 40.0, -10.0}, 14.0, {110, 240, 140}}};
    return scene;
}

std::vector<Image> window_icons() {
    const Scene scene = icon_scene();
    const DrawnSpheres drawn = drawn_spheres(scene);
    std::vector<Image> icons;
    for (const int side : {16, 32, 48, 64}) {
        OpenBackend cpu;
        Timings timings;
        PictureFacts facts;
        PictureOptions options{.camera = scene.camera, .size = {side, side}, .background = scene.background};
        options.samples = sample_counts.back();
        options.shading = Shading::headlight;
        icons.push_back(render_picture(cpu, scene, drawn, options, timings, facts, [](double) {}));
    }
    return icons;
}

}  // namespace sphereview

// What the viewer's picture costs while a sphere is dragged or the camera moves: from the edit to the pixels, at each grid; and
// what is drawn over it.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "camera/navigation.hpp"
#include "cost.hpp"
#include "gpu/live_picture.hpp"
#include "platform/gl_context.hpp"
#include "random_scene.hpp"

namespace {

using namespace sphereview;

constexpr PictureSize size{1000, 1000};
constexpr WindowArea area{0, 0, size.width, size.height};

// A framebuffer in place of a window's.
struct Window {
    Texture texture = Texture::make();
    Framebuffer framebuffer = Framebuffer::make();

    Window() {
        glBindTexture(GL_TEXTURE_2D, texture.name());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
    }
};

}  // namespace

int main(int argc, char** argv) {
    const bool only_orbit = argc == 5 && std::string(argv[4]) == "orbit";
    const bool only_edit = argc == 5 && std::string(argv[4]) == "edit";
    if ((argc != 4 && !only_orbit && !only_edit) || (std::string(argv[1]) != "volume" && std::string(argv[1]) != "half")) {
        std::fprintf(stderr, "usage: live volume|half COUNT RUNS [orbit|edit]: one JSON line on standard output\n");
        return 2;
    }
    const std::size_t count = std::strtoul(argv[2], nullptr, 10);
    const int runs = std::max(1, std::atoi(argv[3]));
    const Scene scene = random_scene(std::string(argv[1]) == "volume" ? SceneSet::volume : SceneSet::half, count);
    Document document(scene);
    const View view{scene.camera, size};
    GlContext& context = *open_egl(list_egl_devices().at(0)).release();
    const Window& window = *new Window;
    glBindFramebuffer(GL_FRAMEBUFFER, window.framebuffer.name());
    LivePicture& picture = *new LivePicture;
    Selection one;
    one.set_only(0);

    const auto show = [&](const Highlights& highlights) {
        picture.show(area, scene.background, highlights);
        glFinish();
    };
    Sphere sphere = scene.spheres.at(0);
    const auto drag = [&] {
        sphere.center.x += 0.01;
        document.apply(ChangeSpheres{{0}, {sphere}}, "drag", 1);
    };
    std::printf("{\"set\": \"%s\", \"count\": %zu, ", argv[1], count);
    if (only_edit) {
        std::vector<double> edits;
        picture.update(document, view, 8);
        for (int run = 0; run < runs; ++run) {
            drag();
            picture.update(document, view, 8);
            edits.push_back((picture.last_seconds() - picture.last_drawing_seconds()) * 1e3);
        }
        std::ranges::sort(edits);
        print("edit apart from drawing", {edits[edits.size() / 2], 0.0});
        std::printf("\"renderer\": \"%s\"}\n", context.renderer().c_str());
        std::fflush(stdout);
        std::_Exit(0);
    }
    if (only_orbit) {
        View orbit = view;
        const auto turn = [&] { orbit.camera = orbited(orbit.camera, {0.0, 0.0, 600.0}, 0.01, 0.0); };
        for (const int step : {1, 2, 4, 8}) {
            const Cost cost = median_cost(runs, [&] {
                turn();
                picture.update(document, orbit, step);
                show({&one, {}, 2.0F});
            });
            print(("orbit, step " + std::to_string(step)).c_str(), cost);
        }
        print("pick in an orbit", median_cost(runs, [&] { picture.pick(document, {501, 333}); }));
        std::printf("\"renderer\": \"%s\"}\n", context.renderer().c_str());
        std::fflush(stdout);
        std::_Exit(0);
    }
    for (const int step : {1, 2, 4, 8}) {
        const Cost cost = median_cost(runs, [&] {
            drag();
            picture.update(document, view, step);
            show({&one, {}, 2.0F});
        });
        print(("drag, step " + std::to_string(step)).c_str(), cost);
    }
    picture.update(document, view, 1);
    const Cost color_cost = median_cost(runs, [&] {
        ++sphere.color.r;
        document.apply(ChangeSpheres{{0}, {sphere}}, "colour", 2);
        picture.update(document, view, 1);
        show({});
    });
    print("colour", color_cost);
    print("show", median_cost(runs, [&] { show({}); }));
    print("show with outline", median_cost(runs, [&] { show({&one, {}, 2.0F}); }));
    sphere.center = {0.0, 0.0, 200.0};
    sphere.radius = 80.0;
    document.apply(ChangeSpheres{{0}, {sphere}}, "enlarge");
    picture.update(document, view, 1);
    print("show with a large outline", median_cost(runs, [&] { show({&one, {}, 2.0F}); }));
    std::printf("\"renderer\": \"%s\"}\n", context.renderer().c_str());
    std::fflush(stdout);
    std::_Exit(0);
}

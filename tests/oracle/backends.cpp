#include "oracle/backends.hpp"

#include <cstdlib>
#include <string_view>

#include "app/render_picture.hpp"

namespace sphereview::oracle {

std::vector<Backend> tested_backends() {
    const char* setting = std::getenv("SPHEREVIEW_BACKENDS");
#ifdef _WIN32
    constexpr const char* usual = "cpu,wgl";
#else
    constexpr const char* usual = "cpu,egl,osmesa";
#endif
    const std::string_view wanted = setting != nullptr ? setting : usual;
    std::vector<Backend> backends;
    for (const Backend backend : {Backend::cpu, Backend::egl, Backend::osmesa, Backend::wgl}) {
        if (wanted.find(name_of(backend)) != std::string_view::npos) backends.push_back(backend);
    }
    return backends;
}

TileCosts with_small_budget(TileCosts costs) {
    costs.shared_budget = 1 << 18;
    return costs;
}

OpenBackend opened(Backend backend) {
    Timings timings;
    return open_backend(backend, std::nullopt, timings);
}

Image flat_picture(OpenBackend& backend, const Scene& scene, PictureSize size, bool certify, DecisionCounts* counts) {
    Timings timings;
    PictureFacts facts;
    const PictureOptions options{scene.camera, size, scene.background, certify};
    Image picture = render_picture(backend, scene, drawn_spheres(scene), options, timings, facts, [](double) {});
    if (counts != nullptr) *counts += facts.decisions;
    return picture;
}

std::vector<std::int32_t> visible_spheres(OpenBackend& backend, const Trial& trial, bool certify, DecisionCounts* counts) {
    Scene numbered = trial.scene;
    numbered.background = {};
    for (std::size_t i = 0; i < numbered.spheres.size(); ++i) {
        const auto byte = [&](unsigned shift) { return static_cast<std::uint8_t>((i + 1) >> shift & 0xffU); };
        numbered.spheres[i].color = {byte(16), byte(8), byte(0)};
    }
    const Image image = flat_picture(backend, numbered, trial.size, certify, counts);
    std::vector<std::int32_t> numbers;
    numbers.reserve(static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()));
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const std::uint8_t* pixel = image.at(x, y);
            numbers.push_back((pixel[0] << 16 | pixel[1] << 8 | pixel[2]) - 1);
        }
    }
    return numbers;
}

}  // namespace sphereview::oracle

#include "app/load_scene.hpp"

#include <algorithm>

#include "base/available_memory.hpp"
#include "base/input_file.hpp"
#include "base/text.hpp"
#include "formats/scene_format.hpp"

namespace sphereview {

namespace {

// Small enough to stay in the processor's cache, large enough to keep many cores at work.
constexpr std::size_t block = std::size_t{1} << 22;

std::vector<Sphere> read_text(InputStream& stream, const LoadOptions& options) {
    SphereTextReader reader(stream.name(), {}, stream.size());
    reader.expect_bytes_per_sphere(sizeof(Sphere) + options.more_per_sphere);
    while (true) {
        stream.drop_first(reader.read(stream.bytes(), stream.ended()));
        if (stream.ended()) return reader.take_spheres();
        if (options.progress != nullptr) options.progress->update(reader.fraction());
        stream.fill(std::max(block, 2 * stream.bytes().size()));  // more than a block when a token has not ended in it
    }
}

LoadedScene read_scene(const std::string& path, const LoadOptions& options) {
    InputStream stream(path);
    if (WorkControl* control = options.control) {
        control->total = stream.size().value_or(0);
        stream.watch([control](std::size_t bytes) {
            control->done = bytes;
            control->check();
        });
    }
    Progress* progress = options.progress;
    if (progress != nullptr) progress->start(stream.name(), 1e-6 * static_cast<double>(stream.size().value_or(0)), "MB");
    stream.fill(std::min(block, stream.size().value_or(block) + 1));
    LoadedScene loaded;
    loaded.name = stream.name();
    loaded.format = detect_format(stream.bytes(), stream.name());
    loaded.has_camera = !is_data(loaded.format);
    if (loaded.has_camera) require_frame(loaded.name, options.data.frame, 1);
    if (loaded.format == SceneFormat::text) {
        loaded.scene.spheres = read_text(stream, options);
        return loaded;
    }
    stream.fill();
    if (options.control != nullptr) options.control->check();
    if (loaded.format == SceneFormat::toml) {
        loaded.scene = parse_scene(stream.bytes(), loaded.name);
        return loaded;
    }
    SphereData data = read_data(stream.bytes(), loaded.name, loaded.format, options.data);
    const std::size_t count = data.scene.spheres.size();
    require_memory(count * options.more_per_sphere, loaded.name + ": " + in_groups(count) + " spheres need");
    loaded.scene = std::move(data.scene);
    loaded.frames = data.frames;
    return loaded;
}

}  // namespace

LoadedScene load_scene(const std::string& path, const LoadOptions& options) {
    LoadedScene loaded = read_scene(path, options);
    if (options.control != nullptr) options.control->check();
    const FitOptions& fit = options.fit;
    if (!fit.wanted.value_or(!loaded.has_camera)) return loaded;
    Camera& camera = loaded.scene.camera;
    const ViewAxes present = loaded.has_camera ? axes_of(camera) : data_axes;
    camera = fitted(loaded.scene, with_hand_of(present, fit.view.value_or(present))).value_or(camera);
    return loaded;
}

}  // namespace sphereview

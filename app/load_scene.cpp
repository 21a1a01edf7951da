#include "app/load_scene.hpp"

#include <algorithm>

#include "base/input_file.hpp"
#include "scene/scene_format.hpp"

namespace sphereview {

namespace {

// Small enough to stay in the processor's cache, large enough to keep many cores at work.
constexpr std::size_t block = std::size_t{1} << 22;

std::vector<Sphere> read_text(InputStream& stream, Progress* progress, std::size_t more_per_sphere) {
    SphereTextReader reader(stream.name(), {}, stream.size());
    reader.expect_bytes_per_sphere(sizeof(Sphere) + more_per_sphere);
    while (true) {
        stream.drop_first(reader.read(stream.bytes(), stream.ended()));
        if (stream.ended()) return reader.take_spheres();
        if (progress != nullptr) progress->update(reader.fraction());
        stream.fill(std::max(block, 2 * stream.bytes().size()));  // more than a block when a token has not ended in it
    }
}

}  // namespace

LoadedScene load_scene(const std::string& path, Progress* progress, std::size_t more_per_sphere) {
    InputStream stream(path);
    if (progress != nullptr) progress->start(stream.name(), 1e-6 * static_cast<double>(stream.size().value_or(0)), "MB");
    stream.fill(std::min(block, stream.size().value_or(block) + 1));
    if (detect_format(stream.bytes(), stream.name()) == SceneFormat::text) {
        Scene scene;
        scene.spheres = read_text(stream, progress, more_per_sphere);
        return {std::move(scene), stream.name(), SceneFormat::text};
    }
    stream.fill();
    return {parse_scene(stream.bytes(), stream.name()), stream.name(), SceneFormat::toml};
}

}  // namespace sphereview

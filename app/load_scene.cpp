#include "app/load_scene.hpp"

#include "base/input_file.hpp"
#include "scene/scene_format.hpp"

namespace sphereview {

LoadedScene load_scene(const std::string& path) {
    InputFile file(path);
    Scene scene = parse_scene(file.bytes(), file.name(), [&](std::size_t bytes) { file.release_first(bytes); });
    return {std::move(scene), file.name()};
}

}  // namespace sphereview

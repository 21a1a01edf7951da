#include "base/error.hpp"
#include "formats/scene_format.hpp"
#include "fuzz/targets.hpp"
#include "unit/scene_difference.hpp"

namespace sphereview {

namespace {

std::string lost(const Scene& scene, const SceneFormat& format, const Scene& expected) {
    const std::string written = write_scene(scene, format);
    try {
        const std::string different = difference(parse_scene(written, "again"), expected);
        return different.empty() ? "" : different + " in:\n" + written;
    } catch (const InputError& error) {
        return std::string(error.what()) + " in:\n" + written;
    }
}

}  // namespace

std::string fuzz_scene(std::string_view bytes) {
    for (const char* name : {"scene.txt", "scene.toml"}) {
        Scene scene;
        try {
            scene = parse_scene(bytes, name);
        } catch (const InputError&) {
            continue;
        } catch (const MemoryError&) {
            continue;
        }
        std::string wrong = lost(scene, SceneFormat::toml, scene);
        if (wrong.empty()) wrong = lost(scene, SceneFormat::text, without_extras(scene));
        if (!wrong.empty()) return wrong;
    }
    return "";
}

}  // namespace sphereview

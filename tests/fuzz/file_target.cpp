#include "app/load_scene.hpp"
#include "base/error.hpp"
#include "base/gunzip.hpp"
#include "formats/scene_format.hpp"
#include "fuzz/targets.hpp"
#include "support/temporary_folder.hpp"
#include "unit/scene_difference.hpp"

namespace sphereview {

namespace {

// A scene, or why there is none.
struct Reading {
    Scene scene{};
    std::string message{};
};

template <typename Read>
Reading reading(const Read& read) {
    try {
        return {read(), ""};
    } catch (const InputError& error) {
        return {{}, error.what()};
    } catch (const MemoryError& error) {
        return {{}, error.what()};
    }
}

}  // namespace

std::string fuzz_file(std::string_view bytes) {
    static const test::TemporaryFolder folder;
    const std::string path = folder.write("scene", bytes);
    const Reading streamed = reading([&] { return load_scene(path, {.fit = {.wanted = false}}).scene; });
    if (bytes.starts_with(gzip_magic)) return "";
    const Reading whole = reading([&] { return parse_scene(bytes, path); });
    if (whole.message != streamed.message) return "as it comes in: " + streamed.message + "\nwhole: " + whole.message;
    return difference(streamed.scene, whole.scene);
}

}  // namespace sphereview

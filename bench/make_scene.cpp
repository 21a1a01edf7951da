// Writes a random scene in the text format to standard output. usage: make_scene volume|half COUNT [SEED]
#include <cstdio>
#include <cstdlib>

#include "random_scene.hpp"
#include "scene/text_format.hpp"

int main(int argc, char** argv) {
    using namespace sphereview;
    const auto set = argc == 3 || argc == 4 ? scene_set_named(argv[1]) : std::nullopt;
    if (!set) {
        std::fprintf(stderr, "usage: make_scene volume|half COUNT [SEED]\n");
        return 2;
    }
    const std::uint64_t seed = argc == 4 ? std::strtoull(argv[3], nullptr, 10) : 1;
    const Scene scene = random_scene(*set, std::strtoull(argv[2], nullptr, 10), seed);
    const std::string text = write_text_spheres(scene.spheres);
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    return written ? 0 : 4;
}

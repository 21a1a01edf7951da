#include "formats/sphere_data.hpp"

#include "base/error.hpp"

namespace sphereview {

SphereData read_data(std::string_view content, const std::string& name, SceneFormat format, const DataOptions& options) {
    if (format == SceneFormat::xyz) return read_xyz(content, name, options);
    if (format == SceneFormat::csv) return read_csv(content, name, options);
    if (format == SceneFormat::pdb) return read_pdb(content, name, options);
    if (format == SceneFormat::mmcif) return read_mmcif(content, name, options);
    throw InputError(name + ": this build cannot read " + std::string(words_for(format)));
}

void require_frame(const std::string& name, std::int64_t frame, std::int64_t frames) {
    if (frame >= 0 && frame < frames) return;
    const std::string found =
        frames == 1 ? "1 frame, number 0" : std::to_string(frames) + " frames, 0 to " + std::to_string(frames - 1);
    throw InputError(name + ": found " + found + ", expected frame " + std::to_string(frame));
}

}  // namespace sphereview

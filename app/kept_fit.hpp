// The one camera that sees many frames, kept between runs: who renders a part of them, or renders them again, need not read all of
// a large file for it (formats/kept_findings.hpp).
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "formats/kept_findings.hpp"
#include "scene/camera.hpp"

namespace sphereview {

struct FrameFit {
    Camera camera{};
    glm::dvec3 middle{0.0};  // of all that it sees
};

// `question`: all that the fit comes of besides the file. The same doubles as were kept, or nothing.
std::optional<FrameFit> read_fit(const FileStamp& stamp, const std::string& question);

// `stamp`: from before the frames were read. Keeps nothing where the file has become another one since.
void keep_fit(const FileStamp& stamp, const std::string& question, const FrameFit& fit) noexcept;

}  // namespace sphereview

// Keeps the camera that sees many frames between runs. A run that renders a part of them, or renders them again, then need not read
// all of a large file first (formats/kept_findings.hpp).
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "formats/kept_findings.hpp"
#include "scene/camera.hpp"

namespace sphereview {

struct FrameFit {
    Camera camera{};
    glm::dvec3 middle{0.0};  // of all that the camera sees
};

// The very doubles that were kept, or nothing. `question`: all that the fit depends on besides the file.
std::optional<FrameFit> read_fit(const FileStamp& stamp, const std::string& question);

// `stamp`: the file's before the frames were read. Keeps nothing if the file has changed since.
void keep_fit(const FileStamp& stamp, const std::string& question, const FrameFit& fit) noexcept;

}  // namespace sphereview

#include "app/kept_fit.hpp"

#include <bit>
#include <cstdint>
#include <exception>

#include "app/version.hpp"

namespace sphereview {

namespace {

constexpr FindingKind fits{".camera", std::size_t{1} << 14, 256, std::uint64_t{1} << 20};

// Another release may fit in another way.
std::string with_version(const std::string& question) { return std::string(version) + "\n" + question; }

void write(KeptWriter& to, const glm::dvec3& v) {
    for (int i = 0; i < 3; ++i) to.number(std::bit_cast<std::uint64_t>(v[i]));
}

glm::dvec3 read_vector(KeptReader& from) {
    glm::dvec3 v{0.0};
    for (int i = 0; i < 3; ++i) v[i] = std::bit_cast<double>(from.number());
    return v;
}

}  // namespace

std::optional<FrameFit> read_fit(const FileStamp& stamp, const std::string& question) {
    try {
        const std::optional<std::string> kept = read_finding(fits, stamp, with_version(question));
        if (!kept) return std::nullopt;
        KeptReader from(*kept);
        FrameFit fit;
        for (glm::dvec3* v : {&fit.camera.eye, &fit.camera.center, &fit.camera.right, &fit.camera.up, &fit.middle}) {
            *v = read_vector(from);
        }
        fit.camera.projection = from.number() == 0 ? Projection::perspective : Projection::orthographic;
        return fit;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

void keep_fit(const FileStamp& stamp, const std::string& question, const FrameFit& fit) noexcept {
    try {
        if (stamp_of(stamp.file, stamp.format) != stamp) return;
        KeptWriter to;
        for (const glm::dvec3* v : {&fit.camera.eye, &fit.camera.center, &fit.camera.right, &fit.camera.up, &fit.middle}) {
            write(to, *v);
        }
        to.number(fit.camera.projection == Projection::perspective ? 0 : 1);
        keep_finding(fits, stamp, with_version(question), to.bytes());
    } catch (const std::exception&) {
        // The next run fits again.
    }
}

}  // namespace sphereview

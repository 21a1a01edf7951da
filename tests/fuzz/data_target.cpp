#include <cmath>

#include "base/error.hpp"
#include "formats/scene_format.hpp"
#include "fuzz/targets.hpp"
#include "unit/scene_difference.hpp"

namespace sphereview {

namespace {

// What goes wrong when the bytes are read, and what was read is written and read again; or "".
std::string wrong_with(std::string_view bytes, const char* name) {
    const SceneFormat& format = *find_format(name);
    for (std::int64_t frame = 0; frame < (format.has_frames ? 3 : 1); ++frame) {
        SphereData data;
        DataOptions options{.frame = frame, .virtual_sites = frame != 1};
        options.all_properties = frame < 2;
        try {
            data = format.read(bytes, "data", options);
        } catch (const InputError&) {
            continue;
        } catch (const MemoryError&) {
            continue;
        }
        if (frame >= data.frames) return "a frame beyond the last was read";
        for (const Sphere& sphere : data.scene.spheres) {
            const glm::dvec3& c = sphere.center;
            const bool finite = std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z) && std::isfinite(sphere.radius);
            if (!finite || !(sphere.radius > 0.0)) return "a sphere that none can be";
        }
        for (const Property& property : data.scene.properties) {
            if (size_of(property) != data.scene.spheres.size()) return "another number of values than of spheres";
        }
        const std::string written = write_scene(data.scene, SceneFormat::toml);
        if (data.scene == Scene{}) continue;  // nothing to write
        try {
            const std::string different = difference(parse_scene(written, "again.toml"), data.scene);
            if (!different.empty()) return different + " in:\n" + written;
        } catch (const InputError& error) {
            return std::string(error.what()) + " in:\n" + written;
        }
    }
    return "";
}

}  // namespace

std::string fuzz_xyz(std::string_view bytes) { return wrong_with(bytes, "XYZ"); }

std::string fuzz_csv(std::string_view bytes) { return wrong_with(bytes, "CSV"); }

std::string fuzz_pdb(std::string_view bytes) { return wrong_with(bytes, "PDB"); }

std::string fuzz_mmcif(std::string_view bytes) { return wrong_with(bytes, "mmCIF"); }

std::string fuzz_lammps(std::string_view bytes) { return wrong_with(bytes, "LAMMPS"); }

std::string fuzz_gromacs(std::string_view bytes) { return wrong_with(bytes, "GROMACS"); }

std::string fuzz_poscar(std::string_view bytes) { return wrong_with(bytes, "POSCAR"); }

std::string fuzz_sdf(std::string_view bytes) { return wrong_with(bytes, "SDF"); }

std::string fuzz_pqr(std::string_view bytes) { return wrong_with(bytes, "PQR"); }

std::string fuzz_ply(std::string_view bytes) { return wrong_with(bytes, "PLY"); }

}  // namespace sphereview

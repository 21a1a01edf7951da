// Writes a random scene to standard output: in the text format, or its spheres as data.
// usage: make_scene volume|half COUNT [SEED [text|xyz|extxyz|csv|pdb|mmcif|cif|lammps|gro|poscar|sdf|pqr|ply|binary_ply]]
#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "base/text.hpp"
#include "formats/text_format.hpp"
#include "random_scene.hpp"

namespace sphereview {
namespace {

std::string joined(std::initializer_list<double> values, char separator) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : std::string(1, separator)) + shortest(value);
    return text;
}

std::string lines_of(const Scene& scene, const std::string& head, const std::string& first, char separator, bool whole) {
    std::string text = head;
    for (const Sphere& sphere : scene.spheres) {
        const auto& [center, radius, color, hidden] = sphere;
        text += first + joined({center.x, center.y, center.z}, separator);
        if (whole) text += separator + joined({radius, double(color.r), double(color.g), double(color.b)}, separator);
        text += '\n';
    }
    return text;
}

// Lines in columns: `format` takes the atom's number and that of its residue, which begin anew where the columns end, x, y, z and
// the radius.
std::string columns_of(const Scene& scene, const std::string& head, const char* format) {
    std::string text = head;
    std::array<char, 128> line{};
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const Sphere& sphere = scene.spheres[i];
        const glm::dvec3& c = sphere.center;
        const int length = std::snprintf(line.data(), line.size(), format, i % 100'000, i % 10'000, c.x, c.y, c.z, sphere.radius);
        text.append(line.data(), static_cast<std::size_t>(length));
    }
    return text;
}

std::string cif_of(const Scene& scene) {
    std::string head = "data_random\n";
    for (const char* edge : {"a", "b", "c"}) head += std::string("_cell_length_") + edge + " 1\n";
    head += "loop_\n_atom_site_type_symbol\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n";
    return lines_of(scene, head, "C ", ' ', false);
}

std::string lammps_of(const Scene& scene) {
    const std::string count = std::to_string(scene.spheres.size());
    const std::string head = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n" + count +
                             "\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\nITEM: ATOMS element x y z radius\n";
    return lines_of(scene, head, "C ", ' ', true);
}

std::string sdf_of(const Scene& scene) {
    const std::string head = "\n\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\nM  V30 COUNTS " +
                             std::to_string(scene.spheres.size()) + " 0 0 0 0\nM  V30 BEGIN ATOM\n";
    return lines_of(scene, head, "M  V30 1 C ", ' ', false) + "M  V30 END ATOM\nM  V30 END CTAB\nM  END\n";
}

std::string ply_head(const Scene& scene, const char* format) {
    std::string head = std::string("ply\nformat ") + format + " 1.0\nelement vertex " + std::to_string(scene.spheres.size()) + "\n";
    for (const char* name : {"x", "y", "z", "radius"}) head += std::string("property double ") + name + "\n";
    for (const char* name : {"red", "green", "blue"}) head += std::string("property uchar ") + name + "\n";
    return head + "end_header\n";
}

std::string binary_ply_of(const Scene& scene) {
    std::string bytes = ply_head(scene, "binary_little_endian");
    for (const Sphere& sphere : scene.spheres) {
        const std::array<double, 4> numbers = {sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius};
        bytes.append(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
        for (const std::uint8_t channel : {sphere.color.r, sphere.color.g, sphere.color.b}) bytes += static_cast<char>(channel);
    }
    return bytes;
}

std::string mmcif_of(const Scene& scene) {
    const std::string head =
        "data_random\nloop_\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
    return lines_of(scene, head, "C ", ' ', false);
}

// Nothing for a format that it does not know.
std::optional<std::string> written(const Scene& scene, std::string_view format) {
    const std::string count = std::to_string(scene.spheres.size());
    if (format == "text") return write_text_spheres(scene.spheres);
    if (format == "xyz") return lines_of(scene, count + "\nrandom\n", "C ", ' ', false);
    const std::string properties = "\nProperties=species:S:1:pos:R:3:radius:R:1:color:I:3\n";
    if (format == "extxyz") return lines_of(scene, count + properties, "C ", ' ', true);
    if (format == "csv") return lines_of(scene, "x,y,z,radius,r,g,b\n", "", ',', true);
    if (format == "pdb") {
        return columns_of(scene, "", "ATOM  %5zu  C   UNL A%4zu    %8.3f%8.3f%8.3f  1.00  0.00           C\n");
    }
    if (format == "mmcif") return mmcif_of(scene);
    if (format == "cif") return cif_of(scene);
    if (format == "lammps") return lammps_of(scene);
    if (format == "gro") return columns_of(scene, "random\n" + count + "\n", "%5zuUNL      C%5zu%8.3f%8.3f%8.3f\n") + " 1 1 1\n";
    if (format == "poscar") {
        return lines_of(scene, "random\n1\n1 0 0\n0 1 0\n0 0 1\nC\n" + count + "\nDirect\n", "", ' ', false);
    }
    if (format == "sdf") return sdf_of(scene);
    if (format == "pqr") return columns_of(scene, "", "ATOM  %5zu  C   UNL A%4zu    %8.3f %8.3f %8.3f 0.1000 %6.4f\n");
    if (format == "ply") return lines_of(scene, ply_head(scene, "ascii"), "", ' ', true);
    if (format == "binary_ply") return binary_ply_of(scene);
    return std::nullopt;
}

}  // namespace
}  // namespace sphereview

int main(int argc, char** argv) {
    using namespace sphereview;
    const auto set = argc >= 3 && argc <= 5 ? scene_set_named(argv[1]) : std::nullopt;
    std::optional<std::string> text;
    if (set) {
        const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
        text = written(random_scene(*set, std::strtoull(argv[2], nullptr, 10), seed), argc > 4 ? argv[4] : "text");
    }
    if (!text) {
        std::fprintf(stderr,
                     "usage: make_scene volume|half COUNT [SEED "
                     "[text|xyz|extxyz|csv|pdb|mmcif|cif|lammps|gro|poscar|sdf|pqr|ply|binary_ply]]\n");
        return 2;
    }
    const bool good = std::fwrite(text->data(), 1, text->size(), stdout) == text->size() && std::fflush(stdout) == 0;
    return good ? 0 : 4;
}

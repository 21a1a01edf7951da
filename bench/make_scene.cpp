// Writes a random scene to standard output: in the text format, or its spheres as data.
// usage: make_scene volume|half COUNT [SEED [text|xyz|extxyz|csv|pdb|mmcif]]
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

// Carbon atoms in residues of one atom, whose numbers begin anew where the columns end.
std::string pdb_of(const Scene& scene) {
    std::string text;
    std::array<char, 96> line{};
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const glm::dvec3& c = scene.spheres[i].center;
        const int length =
            std::snprintf(line.data(), line.size(), "ATOM  %5zu  C   UNL A%4zu    %8.3f%8.3f%8.3f  1.00  0.00           C\n",
                          i % 100'000, i % 10'000, c.x, c.y, c.z);
        text.append(line.data(), static_cast<std::size_t>(length));
    }
    return text;
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
    if (format == "pdb") return pdb_of(scene);
    if (format == "mmcif") return mmcif_of(scene);
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
        std::fprintf(stderr, "usage: make_scene volume|half COUNT [SEED [text|xyz|extxyz|csv|pdb|mmcif]]\n");
        return 2;
    }
    const bool good = std::fwrite(text->data(), 1, text->size(), stdout) == text->size() && std::fflush(stdout) == 0;
    return good ? 0 : 4;
}

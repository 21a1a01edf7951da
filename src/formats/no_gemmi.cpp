// In the place of mmcif_reader.cpp where gemmi is not there.
#include "base/error.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

SphereData read_mmcif(std::string_view, const std::string& name, const DataOptions&) {
    throw InputError(name + ": this program was built without gemmi, and cannot read mmCIF");
}

}  // namespace sphereview

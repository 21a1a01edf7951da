// What the fuzzers try: every reader of what others have written.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace sphereview {

// Each returns what went wrong, or "". A faulty input may end in an InputError or in a MemoryError. All other exceptions escape.

// Reads the bytes as a scene, as text and as TOML; what can be read must survive being written and read again, bit for bit.
std::string fuzz_scene(std::string_view bytes);

// Reads a file of the bytes as the program does: its format is known by its content, it may be packed, and it is read as it comes
// in. The reading of its whole content must give the same scene or the same message.
std::string fuzz_file(std::string_view bytes);

// Reads the bytes as data; what can be read must have spheres that can be, and survive being written as TOML and read again.
std::string fuzz_xyz(std::string_view bytes);
std::string fuzz_csv(std::string_view bytes);
std::string fuzz_pdb(std::string_view bytes);
std::string fuzz_mmcif(std::string_view bytes);
std::string fuzz_ply(std::string_view bytes);
std::string fuzz_pqr(std::string_view bytes);
std::string fuzz_sdf(std::string_view bytes);
std::string fuzz_poscar(std::string_view bytes);
std::string fuzz_gromacs(std::string_view bytes);
std::string fuzz_lammps(std::string_view bytes);

// Reads the bytes as a golden PNG; what can be read must survive being written and read again, and can be compared with any
// picture.
std::string fuzz_png(std::string_view bytes);

// Reads the bytes as a picture of another program.
std::string fuzz_picture(std::string_view bytes);

// Unpacks the bytes as gzip, all at once and piece by piece, which must give the same text or the same fault.
std::string fuzz_gunzip(std::string_view bytes);

// Reads the bytes as a manifest of pictures, line by line: each gives an entry or a fault that names this line.
std::string fuzz_manifest(std::string_view bytes);

// Reads the bytes as the window's settings, which must be the same when they were saved and read again.
std::string fuzz_settings(std::string_view bytes);

// Reads the bytes as what another run of the window has kept.
std::string fuzz_recovery(std::string_view bytes);

struct FuzzTarget {
    const char* name;  // of the folder in tests/fuzz/corpus, too
    std::string (*wrong_with)(std::string_view bytes);
};
inline constexpr std::array fuzz_targets = {
    FuzzTarget{"scene", fuzz_scene},       FuzzTarget{"file", fuzz_file},         FuzzTarget{"xyz", fuzz_xyz},
    FuzzTarget{"csv", fuzz_csv},           FuzzTarget{"pdb", fuzz_pdb},           FuzzTarget{"mmcif", fuzz_mmcif},
    FuzzTarget{"lammps", fuzz_lammps},     FuzzTarget{"gromacs", fuzz_gromacs},   FuzzTarget{"poscar", fuzz_poscar},
    FuzzTarget{"sdf", fuzz_sdf},           FuzzTarget{"pqr", fuzz_pqr},           FuzzTarget{"ply", fuzz_ply},
    FuzzTarget{"png", fuzz_png},           FuzzTarget{"picture", fuzz_picture},   FuzzTarget{"gunzip", fuzz_gunzip},
    FuzzTarget{"settings", fuzz_settings}, FuzzTarget{"recovery", fuzz_recovery}, FuzzTarget{"manifest", fuzz_manifest},
};

}  // namespace sphereview

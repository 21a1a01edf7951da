// What the fuzzers try, and what the unit tests replay on the corpus.
#pragma once

#include <string>
#include <string_view>

namespace sphereview {

// Reads the bytes as a scene, by either name; what can be read must survive being written and read again, bit for bit.
// Returns what went wrong, or "". Exceptions other than InputError escape.
std::string fuzz_scene(std::string_view bytes);

// Reads the bytes as data; what can be read must have spheres that can be, and survive being written as TOML and read again.
std::string fuzz_xyz(std::string_view bytes);
std::string fuzz_csv(std::string_view bytes);
std::string fuzz_pdb(std::string_view bytes);
std::string fuzz_mmcif(std::string_view bytes);

// Reads the bytes as a PNG; what can be read must survive being written and read again.
std::string fuzz_png(std::string_view bytes);

// Unpacks the bytes as gzip, all at once and piece by piece, which must give the same text or the same fault.
std::string fuzz_gunzip(std::string_view bytes);

}  // namespace sphereview

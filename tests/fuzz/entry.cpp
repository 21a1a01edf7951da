// libFuzzer's way into the targets: fuzz TARGET [OPTION OF LIBFUZZER | FOLDER OF INPUTS]...
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/targets.hpp"

namespace {

const sphereview::FuzzTarget* target = nullptr;

}  // namespace

// Takes the target's name from the arguments.
extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
    const std::string_view name = *count > 1 ? (*arguments)[1] : "";
    target = std::ranges::find(sphereview::fuzz_targets, name, &sphereview::FuzzTarget::name);
    if (target == sphereview::fuzz_targets.end()) {
        std::fprintf(stderr, "expected the name of a target first, one of:\n");
        for (const sphereview::FuzzTarget& known : sphereview::fuzz_targets) std::fprintf(stderr, "%s\n", known.name);
        std::exit(2);
    }
    (*arguments)[1] = (*arguments)[0];
    ++*arguments;
    --*count;
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string wrong = target->wrong_with({reinterpret_cast<const char*>(data), size});
    if (wrong.empty()) return 0;
    std::fprintf(stderr, "%s\n", wrong.c_str());
    std::abort();
}

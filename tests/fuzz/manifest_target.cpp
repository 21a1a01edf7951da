#include <algorithm>

#include "app/manifest.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "fuzz/targets.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview {

std::string fuzz_manifest(std::string_view bytes) {
    static const test::TemporaryFolder folder;
    const std::string path = folder.write("manifest", bytes);
    // More than there are: a CR ends a line as well, and CR LF ends one.
    const auto most =
        static_cast<std::size_t>(std::ranges::count_if(bytes, [](char byte) { return byte == '\n' || byte == '\r'; }));
    try {
        const ManifestLines lines = read_manifest(path);
        if (lines.entries.size() > most) return "more entries than lines";
        for (const ManifestEntry& entry : lines.entries) {
            if (entry.frame < 0) return "a frame before the first";
            if (options_of_one(entry).size() > entry.options.size()) return "more options of one picture than of all";
        }
    } catch (const InputError& error) {
        const std::string_view said = error.what();
        for (std::size_t line = 1; line <= most; ++line) {
            if (said.starts_with(path + ":" + std::to_string(line) + ":")) return "";
        }
        return "a fault without its line: " + std::string(said);
    } catch (const MemoryError&) {
    }
    return "";
}

}  // namespace sphereview

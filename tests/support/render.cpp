#include "support/render.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

namespace sphereview::test {

std::string many_spheres(int count) {
    std::string text = std::to_string(count) + "\n";
    for (int i = 0; i < count; ++i) text += "1 2 3\n0 0 " + std::to_string(1000 + i) + "\n1\n";
    return text;
}

std::string endless_scene() {
    constexpr int count = 6;
    std::array<char, 64> line{};
    std::string text = std::to_string(count) + "\n";
    for (int i = 0; i < count; ++i) {
        std::snprintf(line.data(), line.size(), "1 2 3  0 0 0  %.17g\n", 1000 + i * 0x1p-43);
        text += line.data();
    }
    return text;
}

Command cpu_render(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
    return {.arguments = all_words({"render", "--backend", "cpu"}, arguments), .folder = folder.path()};
}

Outcome render(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
    return run(cpu_render(folder, arguments));
}

Picture picture_of(const std::string& scene, const std::string& backend, const std::vector<std::string>& options) {
    const Outcome outcome =
        run({.arguments = all_words({"render", "-", "-o", "-", "--backend", backend}, options), .input = scene});
    EXPECT_EQ(outcome.status, 0) << outcome;
    // Random scenes may be beside a small picture.
    const bool warned = outcome.errors == "stdin: no pixel shows a sphere; --fit frames all\n";
    EXPECT_TRUE(outcome.errors.empty() || warned) << outcome;
    return decode_png(outcome.output);
}

}  // namespace sphereview::test

// A fresh folder for one test's files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sphereview::test {

// Made empty on construction, removed with all it holds on destruction.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    // The folder, or a file in it, as an absolute path. All names are UTF-8.
    std::string path() const;
    std::string path(const std::string& name) const;

    // Writes a file, and the folders above it, and returns its path.
    std::string write(const std::string& name, std::string_view bytes) const;

    // The bytes of a file; fails the test and returns "" when it cannot be read.
    std::string read(const std::string& name) const;

    bool has(const std::string& name) const;

    // The names of all that lies directly in it, hidden files too, sorted.
    std::vector<std::string> names() const;

private:
    std::filesystem::path file(const std::string& name) const;

    std::filesystem::path root_;
};

}  // namespace sphereview::test

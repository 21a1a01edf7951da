#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>

#include "base/path.hpp"

namespace sphereview::test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    std::random_device random;
    do {
        root_ = fs::canonical(fs::temp_directory_path()) / ("sphereview-test-" + std::to_string(random()));
    } while (!fs::create_directory(root_));
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
}

std::string TemporaryFolder::path() const { return text_from(root_); }
std::string TemporaryFolder::path(const std::string& name) const { return text_from(file(name)); }
bool TemporaryFolder::has(const std::string& name) const { return fs::exists(file(name)); }

std::string TemporaryFolder::write(const std::string& name, std::string_view bytes) const {
    fs::create_directories(file(name).parent_path());
    std::ofstream stream(file(name), std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!stream.flush()) throw std::runtime_error(path(name) + " cannot be written");
    return path(name);
}

std::string TemporaryFolder::read(const std::string& name) const {
    std::ifstream stream(file(name), std::ios::binary);
    if (!stream) ADD_FAILURE() << path(name) << " cannot be read";
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<std::string> TemporaryFolder::names() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(root_)) names.push_back(text_from(entry.path().filename()));
    std::sort(names.begin(), names.end());
    return names;
}

fs::path TemporaryFolder::file(const std::string& name) const { return root_ / path_from(name); }

}  // namespace sphereview::test

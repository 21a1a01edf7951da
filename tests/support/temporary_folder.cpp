#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>

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

std::string TemporaryFolder::write(const std::string& name, std::string_view bytes) const {
    const fs::path file = root_ / name;
    fs::create_directories(file.parent_path());
    std::ofstream stream(file, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!stream.flush()) throw std::runtime_error(file.string() + " cannot be written");
    return file.string();
}

std::string TemporaryFolder::read(const std::string& name) const {
    std::ifstream stream(root_ / name, std::ios::binary);
    if (!stream) ADD_FAILURE() << (root_ / name) << " cannot be read";
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<std::string> TemporaryFolder::names() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(root_)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace sphereview::test

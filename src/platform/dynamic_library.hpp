// A shared library that is opened at run time, so that the program also starts without it.
#pragma once

#include <string>
#include <vector>

namespace sphereview {

// Stays loaded until the process ends: graphics drivers leave threads and exit handlers behind.
class DynamicLibrary {
public:
    // Opens the first of `names` that exists. When none does, the object is empty and error() says why.
    explicit DynamicLibrary(const std::vector<std::string>& names);

    explicit operator bool() const { return handle_ != nullptr; }
    const std::string& error() const { return error_; }

    // The address of a function, or null.
    void* find(const char* name) const;

private:
    void* handle_ = nullptr;
    std::string error_;
};

}  // namespace sphereview

#include "platform/dynamic_library.hpp"

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

#include "base/text.hpp"

namespace sphereview {

DynamicLibrary::DynamicLibrary(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
#ifdef _WIN32
        handle_ = reinterpret_cast<void*>(LoadLibraryA(name.c_str()));
        const std::string why = handle_ == nullptr ? name + " cannot be loaded" : "";
#else
        handle_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
        const char* message = handle_ == nullptr ? dlerror() : nullptr;
        const std::string why = message != nullptr ? on_one_line(message) : "";
#endif
        if (handle_ != nullptr) return;
        error_ += (error_.empty() ? "" : "; ") + why;
    }
}

void* DynamicLibrary::find(const char* name) const {
    if (handle_ == nullptr) return nullptr;
#ifdef _WIN32
    return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(handle_), name));
#else
    return dlsym(handle_, name);
#endif
}

}  // namespace sphereview

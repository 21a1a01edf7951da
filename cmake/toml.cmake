# toml++: Debian's is a shared library, which can be read as headers alone where one program has to hold all.
find_package(tomlplusplus REQUIRED)
add_library(toml_library INTERFACE)
if(SPHEREVIEW_PORTABLE)
    get_target_property(toml_headers tomlplusplus::tomlplusplus INTERFACE_INCLUDE_DIRECTORIES)
    target_include_directories(toml_library SYSTEM INTERFACE ${toml_headers})
else()
    target_link_libraries(toml_library INTERFACE tomlplusplus::tomlplusplus)
endif()

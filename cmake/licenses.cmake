# What is in the program of others: `sphereview --licenses` prints their licences, and the packages list them.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

# How and what, by the names in packaging/parts.py.
set(parts compiled:boost compiled:cli11 compiled:glad compiled:glm compiled:imgui compiled:json compiled:stb compiled:toml++)
if(SPHEREVIEW_GEMMI)
    list(APPEND parts compiled:gemmi compiled:pegtl)
endif()
if(SPHEREVIEW_PORTABLE)
    list(APPEND parts compiled:libdeflate compiled:libmd compiled:libpng compiled:libstdc++ compiled:zlib shipped:glfw)
    if(TARGET PkgConfig::fontconfig)
        list(APPEND parts compiled:brotli compiled:expat compiled:fontconfig compiled:freetype)
    endif()
elseif(MINGW)
    list(APPEND parts compiled:glfw compiled:libdeflate compiled:libpng compiled:libstdc++ compiled:mingw-w64 compiled:winpthreads compiled:zlib)
elseif(SKBUILD)
    # A wheel, into which auditwheel copies what the linker has found, but for what every Linux has by its rules: the libraries of C and C++,
    # zlib, Expat and those of X. tests/packages/wheel compares.
    list(APPEND parts compiled:pybind11 shipped:glfw shipped:libdeflate shipped:libmd shipped:libpng)
    if(TARGET PkgConfig::fontconfig)
        list(APPEND parts shipped:brotli shipped:fontconfig shipped:freetype)
    endif()
    if(EXISTS /etc/debian_version)
        list(TRANSFORM parts REPLACE "^compiled:(stb|toml\\+\\+)$" "shipped:\\1")  # which elsewhere are headers alone
    endif()
endif()

set(generated ${PROJECT_BINARY_DIR}/generated)
set(licenses_cpp ${generated}/licenses.cpp)
add_custom_command(
    OUTPUT ${licenses_cpp}
    BYPRODUCTS ${generated}/copyright ${generated}/parts.json
    COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/packaging/parts.py build ${generated} ${parts}
    DEPENDS ${PROJECT_SOURCE_DIR}/packaging/parts.py ${PROJECT_SOURCE_DIR}/LICENSE
    COMMENT "Collecting the licences"
    VERBATIM)

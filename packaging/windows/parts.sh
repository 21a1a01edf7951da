#!/bin/sh
# Builds what sphereview links on Windows, with Debian's mingw-w64: packaging/windows/parts.sh FOLDER
# GLFW, Dear ImGui, libdeflate and libpng come from the source packages of the Debian that this runs on, as apt has and verifies them; zlib
# is Debian's own for mingw; what is headers alone is linked from /usr/include. FOLDER is then the only place that the cross compiler
# looks in (mingw.cmake). A folder that is complete already is left as it is.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
sources=$folder/sources
target=x86_64-w64-mingw32
[ ! -e "$folder/complete" ] || exit 0

say() { printf '%s\n' "windows parts: $*" >&2; }

# Downloads and unpacks Debian's source packages that are named, by a list of sources of this script's own: deb-src is rarely set up.
fetch() {
    mkdir -p "$sources/lists/partial"
    release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
    mirror=$(apt-get indextargets --format '$(REPO_URI)' | grep -m 1 '/debian/*$')
    echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $release main" >"$sources/sources.list"
    set -- -qq -o Dir::Etc::SourceList="$sources/sources.list" -o Dir::Etc::SourceParts=/dev/null -o Dir::State::Lists="$sources/lists" \
        -o APT::Sandbox::User=root source "$@"
    (cd "$sources" && apt-get -qq -o Dir::Etc::SourceList="$sources/sources.list" -o Dir::Etc::SourceParts=/dev/null \
        -o Dir::State::Lists="$sources/lists" update && apt-get "$@") >&2
}

# What cmake -S FOLDER builds is installed into the folder of the parts.
cmake_part() {
    part=$1
    shift
    cmake -S "$part" -B "$part/build-windows" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$here/mingw.cmake" -DSPHEREVIEW_WINDOWS_PARTS="$folder" \
        -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$folder" -DBUILD_SHARED_LIBS=OFF "$@"
    cmake --build "$part/build-windows" --target install
}

# The folder of the source package named, whose version differs from release to release.
unpacked() { find "$sources" -mindepth 1 -maxdepth 1 -type d -name "$1-[0-9]*"; }

build() {
    mkdir -p "$folder/include" "$folder/lib"
    for headers in boost glm toml++ CLI nlohmann gemmi tao stb; do
        ln -sfn "/usr/include/$headers" "$folder/include/$headers"
    done
    mkdir -p "$folder/share/cmake"
    for package in glm CLI11 nlohmann_json; do  # these say where the headers are relative to themselves
        cp -R "/usr/share/cmake/$package" "$folder/share/cmake"
    done
    # The package for CMake of toml++ is of the library that Debian builds from the headers.
    mkdir -p "$folder/share/cmake/tomlplusplus"
    printf '%s\n' 'add_library(tomlplusplus::tomlplusplus INTERFACE IMPORTED)' \
        'target_include_directories(tomlplusplus::tomlplusplus INTERFACE ${CMAKE_CURRENT_LIST_DIR}/../../../include)' \
        >"$folder/share/cmake/tomlplusplus/tomlplusplusConfig.cmake"
    ln -sfn "/usr/$target/include/zlib.h" "$folder/include/zlib.h"
    ln -sfn "/usr/$target/include/zconf.h" "$folder/include/zconf.h"
    ln -sfn "/usr/$target/lib/libz.a" "$folder/lib/libz.a"
    cmake_part "$(unpacked glfw3)" -DGLFW_BUILD_DOCS=OFF -DGLFW_BUILD_EXAMPLES=OFF -DGLFW_BUILD_TESTS=OFF
    cmake_part "$(unpacked libpng1.6)" -DPNG_SHARED=OFF -DPNG_TESTS=OFF -DPNG_EXECUTABLES=OFF
    # The sources of GoogleTest are a package of their own; its build folder is beside the others'.
    rm -rf "$sources/googletest-0" && cp -R /usr/src/googletest "$sources/googletest-0"
    cmake_part "$sources/googletest-0" -DBUILD_GMOCK=OFF
    cp "$here/imgui.cmake" "$(unpacked imgui)/CMakeLists.txt"
    cmake_part "$(unpacked imgui)"
    cp "$here/libdeflate.cmake" "$(unpacked libdeflate)/CMakeLists.txt"  # its own came with release 1.15
    cmake_part "$(unpacked libdeflate)"
}

say "building GLFW, Dear ImGui, libdeflate and libpng in $folder"
rm -rf "$sources"
fetch glfw3 imgui libdeflate libpng1.6
build >"$folder/build.log" 2>&1 || { tail -n 40 "$folder/build.log" >&2; say "failed; the whole log is $folder/build.log"; exit 1; }
touch "$folder/complete"

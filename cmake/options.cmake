# How every target of this project is compiled: sphereview_plain_options without sanitizers, sphereview_options with them,
# where the preset has them.
add_library(sphereview_plain_options INTERFACE)
add_library(sphereview_options INTERFACE)
target_link_libraries(sphereview_options INTERFACE sphereview_plain_options)
if(MSVC)
    target_compile_options(sphereview_plain_options INTERFACE /W4 /fp:precise $<$<BOOL:${SPHEREVIEW_WERROR}>:/WX>)
    target_compile_definitions(sphereview_plain_options INTERFACE NOMINMAX)  # std::min and std::max beside windows.h, as MinGW has it
else()
    target_compile_options(sphereview_plain_options INTERFACE
        -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Wold-style-cast
        $<$<BOOL:${SPHEREVIEW_WERROR}>:-Werror>
        # GCC's optimiser warns falsely of the standard library's strings (restrict: GCC bug 105651) and, in GCC 14, of Boost's integers (the
        # other two). That their headers are SYSTEM does not silence it. The sanitizers look for such faults.
        $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow> $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>
        # A tenth of the time to compile, or a seventh: below half a gigabyte, or two, GCC looks for no memory that it could give back to
        # itself. Who builds the tests has the memory.
        $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=$<IF:$<BOOL:${SPHEREVIEW_TESTS}>,2097152,524288>>
        # Part of -Wconversion for Clang alone.
        $<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wno-sign-conversion>
        # Where one source of a unity build follows another, a local name may be that of the other's helper, and what is included is
        # no header, as GCC has it.
        $<$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>:-Wno-shadow> $<$<AND:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>
        # One set of objects for the program and for the Python module, which is a shared library that shows nothing but its entry.
        "$<$<NOT:$<PLATFORM_ID:Windows>>:-fPIC;-fvisibility=hidden>"
        # Exact pictures: no multiplication and addition may be fused behind our back, and a square root is the processor's
        # (base/square_root.hpp).
        -ffp-contract=off -fno-math-errno)
endif()
if(SPHEREVIEW_SANITIZE)
    set(sanitizers address,undefined)
    if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
        # What GCC has not, or not as well: numbers that lose their value in another type, and the bounds of arrays of unknown size.
        string(APPEND sanitizers ,float-cast-overflow,implicit-conversion,local-bounds)
        target_compile_definitions(sphereview_options INTERFACE _GLIBCXX_ASSERTIONS)
        target_compile_options(sphereview_options INTERFACE -fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/sanitizers.ignore)
    endif()
    target_compile_options(sphereview_options INTERFACE -fsanitize=${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer
        # A quarter of the time to compile is for what AddressSanitizer or the processor notices as well; Clang's build looks for all of it.
        $<$<CXX_COMPILER_ID:GNU>:-fno-sanitize=null,alignment,object-size,vptr>)
    target_link_options(sphereview_options INTERFACE -fsanitize=${sanitizers})
endif()
if(SPHEREVIEW_FUZZ)
    if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
        message(FATAL_ERROR "SPHEREVIEW_FUZZ needs Clang's libFuzzer: cmake --preset test-clang")
    endif()
    # The fuzzer follows which branches an input takes.
    target_compile_options(sphereview_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# The standard headers are parsed once for each set of flags, not for each file: add_precompiled(NAME [HEADERS MORE...] LINKS...) makes the precompiled header
# for targets with the flags of LINKS, which take it with use_precompiled(TARGET NAME), and precompile(TARGET HEADERS...) makes one for a
# target alone. ccache needs -fpch-preprocess to see what they hold.
set(standard_headers <algorithm> <array> <atomic> <bit> <cassert> <charconv> <chrono> <cmath> <condition_variable> <cstddef> <cstdint> <cstdio> <cstdlib>
    <cstring> <deque> <exception> <filesystem> <fstream> <functional> <limits> <map> <memory> <mutex> <new> <numeric> <optional> <span> <sstream>
    <stdexcept> <string> <string_view> <system_error> <thread> <tuple> <type_traits> <unordered_map> <utility> <variant> <vector>)

function(precompile target)
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
    target_precompile_headers(${target} PRIVATE ${standard_headers} ${ARGN})
endfunction()

function(add_precompiled name)
    cmake_parse_arguments(precompiled "" "" "HEADERS;LINKS" ${ARGN})
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/${name}.cpp CONTENT "" @ONLY)
    add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/${name}.cpp)
    target_link_libraries(${name} PRIVATE ${precompiled_LINKS})
    precompile(${name} ${precompiled_HEADERS})
endfunction()

function(use_precompiled target name)
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
    target_precompile_headers(${target} REUSE_FROM ${name})
endfunction()

# Several sources are compiled as one, which takes half the time. The price: helpers of a target's sources need different names, and who edits
# one source compiles its neighbours, too; -DCMAKE_UNITY_BUILD=OFF serves those who edit much.
# Two dozen at once: two thirds of the time of CMake's eight, for what templates become is compiled once for all of them; a compiler needs up to
# one and a half gigabytes of memory for them.
if(NOT DEFINED CMAKE_UNITY_BUILD)
    set(CMAKE_UNITY_BUILD ON)
endif()
if(NOT DEFINED CMAKE_UNITY_BUILD_BATCH_SIZE)
    set(CMAKE_UNITY_BUILD_BATCH_SIZE 24)
endif()

# Two kinds of code. `fast` is what computes for each pixel or each sphere: -O3. `plain` is all else: -O1, which takes two thirds of the time
# that -O2 takes to compile, and is as quick where nothing is computed. In a debug build menus and the like are a kind of their own, without optimisation:
# sanitizers double the time that it takes there, and no test waits for a menu.
set(kinds plain fast)
if(CMAKE_BUILD_TYPE STREQUAL Debug)
    list(APPEND kinds menus)
endif()
foreach(kind IN LISTS kinds)
    add_library(${kind} INTERFACE)
endforeach()
if(NOT MSVC)
    # With less than -O3, GCC does not see that a variant's other members are not read, nor how long a string is.
    target_compile_options(plain INTERFACE $<$<CONFIG:Release>:-O1>
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread>)
    # Without traps the compiler may use SIMD for square roots and comparisons; every result stays as IEEE 754 has it.
    target_compile_options(fast INTERFACE -O3 -fno-trapping-math)
    if(TARGET menus)
        target_compile_options(menus INTERFACE -O0)
    endif()
endif()
foreach(kind IN LISTS kinds)
    add_precompiled(precompiled_${kind} LINKS sphereview_options ${kind})
endforeach()

# Compiles a target's sources as KIND has it: plain, fast, or menus.
function(compile_as target kind)
    if(kind STREQUAL menus AND NOT TARGET menus)
        set(kind plain)
    endif()
    target_link_libraries(${target} PRIVATE sphereview_options ${kind})
    use_precompiled(${target} precompiled_${kind})
endfunction()

# A static library from the given sources of this folder, included as "folder/file.hpp"; the FAST ones are an object library, NAME_fast. MENUS: the
# other sources are of that kind.
function(add_room name)
    cmake_parse_arguments(room "MENUS" "" "SOURCES;FAST;LINKS" ${ARGN})
    set(kind plain)
    if(room_MENUS)
        set(kind menus)
    endif()
    set(parts)
    if(room_SOURCES)
        add_library(${name} STATIC ${room_SOURCES})
        compile_as(${name} ${kind})
        set(parts ${name})
    endif()
    if(room_FAST)
        if(room_SOURCES)
            set(fast ${name}_fast)
            add_library(${fast} OBJECT ${room_FAST})
            target_sources(${name} PRIVATE $<TARGET_OBJECTS:${fast}>)
        else()
            set(fast ${name})
            add_library(${fast} STATIC ${room_FAST})
        endif()
        compile_as(${fast} fast)
        # What inlining makes of a fast source must not depend on its neighbours.
        if(NOT CMAKE_BUILD_TYPE STREQUAL Debug)
            set_target_properties(${fast} PROPERTIES UNITY_BUILD OFF)
        endif()
        list(APPEND parts ${fast})
    endif()
    foreach(part IN LISTS parts)
        target_include_directories(${part} PUBLIC ${PROJECT_SOURCE_DIR}/src)
        target_link_libraries(${part} PUBLIC ${room_LINKS})
    endforeach()
    # windows.h, which these two rooms include, must not reach their other sources.
    if(WIN32 AND name MATCHES "^(base|platform)$")
        set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
    endif()
    # For tests that compile a room once more.
    set(sources ${room_SOURCES} ${room_FAST})
    set_target_properties(${name} PROPERTIES ROOM_SOURCES "${sources}")
endfunction()

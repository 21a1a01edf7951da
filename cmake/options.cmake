# How every target of this project is compiled: sphereview_plain_options without sanitizers, sphereview_options with them,
# where the preset has them.
add_library(sphereview_plain_options INTERFACE)
add_library(sphereview_options INTERFACE)
target_link_libraries(sphereview_options INTERFACE sphereview_plain_options)
if(MSVC)
    target_compile_options(sphereview_plain_options INTERFACE /W4 /fp:precise $<$<BOOL:${SPHEREVIEW_WERROR}>:/WX>)
else()
    target_compile_options(sphereview_plain_options INTERFACE
        -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Wold-style-cast
        $<$<BOOL:${SPHEREVIEW_WERROR}>:-Werror>
        # False alarms on joining strings (GCC bug 105651).
        $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
        # Part of -Wconversion for Clang alone.
        $<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wno-sign-conversion>
        # Exact pictures: no multiplication and addition may be fused behind our back.
        -ffp-contract=off)
endif()
if(SPHEREVIEW_SANITIZE)
    target_compile_options(sphereview_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(sphereview_options INTERFACE -fsanitize=address,undefined)
endif()

# A static library from the given sources of this folder, included as "folder/file.hpp".
function(add_room name)
    cmake_parse_arguments(room "" "" "SOURCES;LINKS" ${ARGN})
    add_library(${name} STATIC ${room_SOURCES})
    target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(${name} PUBLIC ${room_LINKS} PRIVATE sphereview_options)
endfunction()

# How parts.sh builds libdeflate, whose source package has a Makefile up to release 1.14 and other names of files since.
cmake_minimum_required(VERSION 3.22)
project(libdeflate LANGUAGES C)
file(GLOB sources lib/*.c lib/x86/*.c)
add_library(deflate STATIC ${sources})
target_include_directories(deflate PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
install(TARGETS deflate ARCHIVE DESTINATION lib)
install(FILES libdeflate.h DESTINATION include)

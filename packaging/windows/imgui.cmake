# How parts.sh builds Dear ImGui, whose source package has a Makefile for Linux: the library and its OpenGL 3 backend, installed with a
# package for CMake.
cmake_minimum_required(VERSION 3.22)
project(imgui LANGUAGES CXX)
add_library(imgui STATIC imgui.cpp imgui_draw.cpp imgui_tables.cpp imgui_widgets.cpp misc/cpp/imgui_stdlib.cpp
    backends/imgui_impl_opengl3.cpp)
target_include_directories(imgui PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/imgui>)
target_link_libraries(imgui PUBLIC opengl32 imm32)
install(TARGETS imgui EXPORT imgui ARCHIVE DESTINATION lib)
install(FILES imconfig.h imgui.h imgui_internal.h imstb_rectpack.h imstb_textedit.h imstb_truetype.h misc/cpp/imgui_stdlib.h
    backends/imgui_impl_opengl3.h
    DESTINATION include/imgui)
install(EXPORT imgui FILE imgui-config.cmake NAMESPACE imgui:: DESTINATION lib/cmake/imgui)

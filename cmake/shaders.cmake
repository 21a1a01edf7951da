# The files of shaders/ as one C++ source, so that the program needs none of them at run time.
set(shader_dir ${PROJECT_SOURCE_DIR}/shaders)
file(GLOB shader_files CONFIGURE_DEPENDS ${shader_dir}/*.vert ${shader_dir}/*.frag ${shader_dir}/*.glsl)
set(embedded_shaders_cpp ${PROJECT_BINARY_DIR}/embedded_shaders.cpp)
add_custom_command(
    OUTPUT ${embedded_shaders_cpp}
    COMMAND ${CMAKE_COMMAND} -DOUT=${embedded_shaders_cpp} "-DFILES=${shader_files}" -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${shader_files} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    COMMENT "Embedding the shaders"
    VERBATIM)

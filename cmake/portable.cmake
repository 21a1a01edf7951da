# A program that runs on any Linux whose C library is not older than the one here: static libraries are linked in where there are any, and the
# others lie beside the program, in ../lib/sphereview.
option(SPHEREVIEW_PORTABLE "Link libraries statically, and look for others beside the program" OFF)
if(SPHEREVIEW_PORTABLE)
    set(CMAKE_FIND_LIBRARY_SUFFIXES .a .so)
    set(PKG_CONFIG_ARGN --static)
    # The C library alone stays shared.
    foreach(module IN ITEMS fontconfig imgui)
        set(pkgcfg_lib_${module}_m m CACHE INTERNAL "")
    endforeach()
    add_link_options(-static-libstdc++ -static-libgcc -Wl,--exclude-libs,ALL)
    set(CMAKE_INSTALL_RPATH "$ORIGIN/../lib/sphereview")
endif()

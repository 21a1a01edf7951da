# Cross-compiles for Windows with Debian's mingw-w64 (posix threads). SPHEREVIEW_WINDOWS_PARTS is the folder that parts.sh made.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_AR x86_64-w64-mingw32-gcc-ar-posix CACHE FILEPATH "")
set(CMAKE_RANLIB x86_64-w64-mingw32-gcc-ranlib-posix CACHE FILEPATH "")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SPHEREVIEW_WINDOWS_PARTS)

# Headers and libraries come from the parts alone; programs, such as glad, from here.
set(CMAKE_FIND_ROOT_PATH ${SPHEREVIEW_WINDOWS_PARTS})
set(CMAKE_PREFIX_PATH ${SPHEREVIEW_WINDOWS_PARTS})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_LIBDIR} ${SPHEREVIEW_WINDOWS_PARTS}/lib/pkgconfig)

# One file that needs no others: libgcc, libstdc++ and the threads are linked in.
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)

# SHA-256: the system's on Windows and macOS, else libmd's, which Debian's own package manager needs as well.
if(WIN32)
    set(HASH_LIBRARY bcrypt)
elseif(NOT APPLE)
    find_library(HASH_LIBRARY md)
    find_path(HASH_INCLUDE_DIR sha2.h)
    if(NOT HASH_LIBRARY OR NOT HASH_INCLUDE_DIR)
        message(FATAL_ERROR "libmd is missing, which has SHA-256: on Debian and Ubuntu the package libmd-dev, on Fedora libmd-devel, "
                            "on Arch, Alpine and Homebrew libmd")
    endif()
endif()

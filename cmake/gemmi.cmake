# gemmi reads PDB and mmCIF; without it the program says that it cannot. Up to 0.5 it is headers only. Its headers for CIF need PEGTL,
# which some packages of gemmi hold and others leave to the system, and Clang 14 does not compile them with the library of GCC 12: so they
# are tried, not looked for. Nor are gemmi's own CMake files asked: Debian 13's name a program that is in another package.
include(CheckCXXSourceCompiles)

option(SPHEREVIEW_WANT_GEMMI "Read PDB and mmCIF, if gemmi is there" ON)
set(SPHEREVIEW_GEMMI FALSE)
if(SPHEREVIEW_WANT_GEMMI)
    add_library(gemmi_library INTERFACE)
    find_path(GEMMI_INCLUDE_DIR gemmi/pdb.hpp)
    find_library(GEMMI_LIBRARY gemmi_cpp)
    mark_as_advanced(GEMMI_INCLUDE_DIR GEMMI_LIBRARY)
    if(GEMMI_INCLUDE_DIR)
        target_include_directories(gemmi_library SYSTEM INTERFACE ${GEMMI_INCLUDE_DIR})
        set(CMAKE_REQUIRED_INCLUDES ${GEMMI_INCLUDE_DIR})
        if(GEMMI_LIBRARY)
            target_link_libraries(gemmi_library INTERFACE ${GEMMI_LIBRARY})
        endif()
        check_cxx_source_compiles("#include <gemmi/cif.hpp>
            int main() { const gemmi::cif::Document read; return static_cast<int>(gemmi::cif::Document(read).blocks.size()); }"
            SPHEREVIEW_HAS_GEMMI_CIF)
        set(SPHEREVIEW_GEMMI ${SPHEREVIEW_HAS_GEMMI_CIF})
        unset(CMAKE_REQUIRED_INCLUDES)
    endif()
endif()
if(NOT SPHEREVIEW_GEMMI)
    message(STATUS "Without gemmi: PDB and mmCIF will not be read")
endif()

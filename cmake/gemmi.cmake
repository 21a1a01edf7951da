# gemmi reads PDB and mmCIF; without it the program says that it cannot. Up to 0.5 it is headers only. Its headers for CIF need PEGTL,
# which some packages of gemmi hold and others leave to the system, and Clang 14 does not compile them with the library of GCC 12: so they
# are tried, not looked for.
include(CheckCXXSourceCompiles)
include(CheckIncludeFileCXX)

option(SPHEREVIEW_WANT_GEMMI "Read PDB and mmCIF, if gemmi is there" ON)
set(SPHEREVIEW_GEMMI FALSE)
if(SPHEREVIEW_WANT_GEMMI)
    find_package(gemmi CONFIG QUIET)
    add_library(gemmi_library INTERFACE)
    if(TARGET gemmi::gemmi_cpp)
        target_link_libraries(gemmi_library INTERFACE gemmi::gemmi_cpp)
        set(SPHEREVIEW_GEMMI TRUE)
    else()
        check_include_file_cxx(gemmi/pdb.hpp SPHEREVIEW_HAS_GEMMI_PDB)
        check_cxx_source_compiles("#include <gemmi/cif.hpp>
            int main() { const gemmi::cif::Document read; return static_cast<int>(gemmi::cif::Document(read).blocks.size()); }"
            SPHEREVIEW_HAS_GEMMI_CIF)
        if(SPHEREVIEW_HAS_GEMMI_PDB AND SPHEREVIEW_HAS_GEMMI_CIF)
            set(SPHEREVIEW_GEMMI TRUE)
        endif()
    endif()
endif()
if(NOT SPHEREVIEW_GEMMI)
    message(STATUS "Without gemmi: PDB and mmCIF will not be read")
endif()

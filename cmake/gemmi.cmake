# gemmi reads mmCIF; without it the program says that it cannot. Up to 0.5 it is headers only. Its headers for CIF need PEGTL,
# which some packages of gemmi hold and others leave to the system: so they are tried, not looked for. Nor are gemmi's own CMake files asked:
# Debian 13's name a program that is in another package.
include(CheckCXXSourceCompiles)

# Whether the headers in the folder can be compiled: sets `result`.
function(try_gemmi folder result)
    set(CMAKE_REQUIRED_INCLUDES ${folder})
    check_cxx_source_compiles("#include <gemmi/cif.hpp>
        int main() { const gemmi::cif::Document read; return static_cast<int>(gemmi::cif::Document(read).blocks.size()); }" ${result})
endfunction()

# A copy of gemmi's headers that Clang compiles. Release 0.5 constructs a block of CIF where the type of its items is not complete; in C++20,
# whose vectors are constexpr, Clang refuses that. The copy has these constructors behind the type, as later releases have them.
function(mend_gemmi headers copy)
    file(COPY ${headers}/gemmi DESTINATION ${copy} PATTERN cifdoc.hpp EXCLUDE)
    file(READ ${headers}/gemmi/cifdoc.hpp text)
    string(REPLACE "explicit Block(const std::string& name_) : name(name_) {}\n  Block() {}"
                   "explicit Block(const std::string& name_);\n  Block();" text "${text}")
    string(REPLACE "struct Document {"
                   "inline Block::Block(const std::string& name_) : name(name_) {}\ninline Block::Block() {}\n\nstruct Document {" text "${text}")
    if(NOT EXISTS ${copy}/gemmi/cifdoc.hpp)
        file(WRITE ${copy}/gemmi/cifdoc.hpp "${text}")
    endif()
endfunction()

option(SPHEREVIEW_WANT_GEMMI "Read mmCIF, if gemmi is there" ON)
set(SPHEREVIEW_GEMMI FALSE)
if(SPHEREVIEW_WANT_GEMMI)
    add_library(gemmi_library INTERFACE)
    find_path(GEMMI_INCLUDE_DIR gemmi/cif.hpp)
    find_library(GEMMI_LIBRARY gemmi_cpp)
    mark_as_advanced(GEMMI_INCLUDE_DIR GEMMI_LIBRARY)
    if(GEMMI_INCLUDE_DIR)
        set(gemmi_headers ${GEMMI_INCLUDE_DIR})
        try_gemmi(${gemmi_headers} SPHEREVIEW_HAS_GEMMI_CIF)
        set(SPHEREVIEW_GEMMI ${SPHEREVIEW_HAS_GEMMI_CIF})
        if(NOT SPHEREVIEW_GEMMI AND EXISTS ${GEMMI_INCLUDE_DIR}/gemmi/cifdoc.hpp)
            set(gemmi_headers ${PROJECT_BINARY_DIR}/gemmi)
            mend_gemmi(${GEMMI_INCLUDE_DIR} ${gemmi_headers})
            try_gemmi(${gemmi_headers} SPHEREVIEW_HAS_MENDED_GEMMI_CIF)
            set(SPHEREVIEW_GEMMI ${SPHEREVIEW_HAS_MENDED_GEMMI_CIF})
        endif()
        target_include_directories(gemmi_library SYSTEM INTERFACE ${gemmi_headers})
        if(GEMMI_LIBRARY)
            target_link_libraries(gemmi_library INTERFACE ${GEMMI_LIBRARY})
        endif()
    endif()
endif()
if(NOT SPHEREVIEW_GEMMI)
    message(STATUS "Without gemmi: mmCIF will not be read")
endif()

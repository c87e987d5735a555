# Most of the time to compile a file goes into the headers of Trilinos. They are compiled once for
# the libraries and once for the test programs, which GCC compiles with other options (-fPIE).
# ASPERITY_PRECOMPILED_HEADERS=OFF, the preset `debug`, shows which file lacks an include.
set(asperity_precompiled_headers
  <Kokkos_Core.hpp> <Teuchos_CommHelpers.hpp> <Teuchos_ParameterList.hpp> <Tpetra_CrsMatrix.hpp>
  <Tpetra_Import.hpp> <Tpetra_Map.hpp> <Tpetra_MultiVector.hpp> <Tpetra_Vector.hpp>
  <filesystem> <functional> <map> <sstream> <string> <vector>)

# asperity_add_precompiled_headers(<use> [HEADERS <header>...] [LIBRARIES <target>...])
function(asperity_add_precompiled_headers use)
  cmake_parse_arguments(ADD "" "" "HEADERS;LIBRARIES" ${ARGN})
  if(NOT ASPERITY_PRECOMPILED_HEADERS)
    return()
  endif()
  set(target asperity_precompiled_${use})
  set(source "${PROJECT_BINARY_DIR}/${target}.cpp")
  file(GENERATE OUTPUT "${source}" CONTENT "int main() {}\n")
  if(use STREQUAL "libraries")
    add_library(${target} OBJECT "${source}")
  else()
    add_executable(${target} EXCLUDE_FROM_ALL "${source}")
  endif()
  target_compile_features(${target} PRIVATE cxx_std_17)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(${target} PRIVATE Asperity::Trilinos ${ADD_LIBRARIES})
  target_link_options(${target} PRIVATE ${asperity_sanitizer_flags})
  target_precompile_headers(${target} PRIVATE ${asperity_precompiled_headers} ${ADD_HEADERS})
endfunction()

function(asperity_use_precompiled_headers target use)
  if(ASPERITY_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM asperity_precompiled_${use})
  endif()
endfunction()

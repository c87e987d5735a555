# Settings of the whole build are not changed where Asperity is part of another project.
set(ASPERITY_IS_TOP_LEVEL OFF)
if(CMAKE_SOURCE_DIR STREQUAL PROJECT_SOURCE_DIR)
  set(ASPERITY_IS_TOP_LEVEL ON)
endif()

option(ASPERITY_ENABLE_TESTS "Build the tests" ${ASPERITY_IS_TOP_LEVEL})
option(ASPERITY_ENABLE_MESH_TOOL "Build asperity-mesh, which uses Gmsh and CGAL (GPL 3)" ON)
option(ASPERITY_ENABLE_INSTALL "Install and export the packages" ${ASPERITY_IS_TOP_LEVEL})
option(ASPERITY_PRECOMPILED_HEADERS "Compile the headers of Trilinos once, for faster builds" ON)
# Off, so that new warnings of newer compilers do not stop the build; quickstart.sh --strict sets
# it.
option(ASPERITY_WARNINGS_AS_ERRORS "Treat warnings in Asperity's own code as errors" OFF)
# The preset `fuzz`: the programs of tests/fuzz are linked with libFuzzer, and other tests are left
# out.
option(ASPERITY_FUZZERS "Build the fuzz targets with libFuzzer, which needs Clang" OFF)
set(ASPERITY_TEST_TIME_FACTOR 1 CACHE STRING
  "Integer factor of the time limits of tests, for slow builds and machines")
# Without Trilinos and MPI (docs/cost/backends.md).
option(ASPERITY_KERNELS_ONLY
  "Build packages/friction and multigrid alone, with Kokkos 3.4 or newer" OFF)
option(ASPERITY_SEPARATE_MEMORY
  "Their kernels have memory that the host must not touch, as on a device (Kokkos 3, Serial)" OFF)
set(ASPERITY_BACKEND "" CACHE STRING
  "The execution space that Kokkos must have: Serial, OpenMP, Cuda; empty accepts any")
set_property(CACHE ASPERITY_BACKEND PROPERTY STRINGS "" Serial OpenMP Cuda)
if(NOT ASPERITY_BACKEND MATCHES "^(|Serial|OpenMP|Cuda)$")
  message(FATAL_ERROR "ASPERITY_BACKEND is '${ASPERITY_BACKEND}'; it may be Serial, OpenMP or "
    "Cuda, or empty for what the Kokkos found has.")
endif()
option(BUILD_SHARED_LIBS "Shared libraries, which `asperity --plugin` needs" ON)

if(NOT BUILD_SHARED_LIBS AND CMAKE_VERSION VERSION_LESS 3.24)
  message(FATAL_ERROR "Asperity's static libraries need CMake 3.24 or newer: older versions drop "
    "objects that only register a law or an output. Set BUILD_SHARED_LIBS=ON.")
endif()

if(ASPERITY_IS_TOP_LEVEL)
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
  # Searched only once: a ccache found later would change the command, and compile everything again.
  if(NOT DEFINED ASPERITY_CCACHE)
    find_program(ASPERITY_CCACHE ccache)
  endif()
  if(ASPERITY_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${ASPERITY_CCACHE}")
  endif()
endif()

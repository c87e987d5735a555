# Makes Asperity::Kokkos of the Kokkos found, 3.4 or newer, alone or as a part of Trilinos, and
# checks that its default execution space is the one of ASPERITY_BACKEND.
if(TARGET Asperity::Kokkos)
  return()
endif()

if(NOT Trilinos_FOUND)
  find_package(Kokkos REQUIRED)
endif()
set(asperity_kokkos_folders "")
if(TARGET Kokkos::kokkoscore)
  get_target_property(asperity_kokkos_folders Kokkos::kokkoscore INTERFACE_INCLUDE_DIRECTORIES)
endif()
find_file(ASPERITY_KOKKOS_CONFIG KokkosCore_config.h NO_DEFAULT_PATH
  HINTS ${asperity_kokkos_folders} ${Kokkos_INCLUDE_DIRS} ${Trilinos_INCLUDE_DIRS}
    "${Kokkos_DIR}/../../../include" "${Kokkos_DIR}/../../../../include"
  PATH_SUFFIXES kokkos trilinos REQUIRED)

# The version, as 3.4.1
file(STRINGS "${ASPERITY_KOKKOS_CONFIG}" asperity_kokkos_number REGEX "^#define KOKKOS_VERSION ")
string(REGEX MATCH "[0-9]+$" asperity_kokkos_number "${asperity_kokkos_number}")
math(EXPR asperity_kokkos_major "${asperity_kokkos_number} / 10000")
math(EXPR asperity_kokkos_minor "${asperity_kokkos_number} / 100 % 100")
math(EXPR asperity_kokkos_patch "${asperity_kokkos_number} % 100")
set(ASPERITY_KOKKOS_VERSION
  "${asperity_kokkos_major}.${asperity_kokkos_minor}.${asperity_kokkos_patch}")
if(ASPERITY_KOKKOS_VERSION VERSION_LESS 3.4)
  message(FATAL_ERROR "Asperity needs Kokkos 3.4 or newer; ${ASPERITY_KOKKOS_CONFIG} has "
    "version ${ASPERITY_KOKKOS_VERSION}.")
endif()

# Kokkos takes the first of these that it was built with for its default execution space.
set(ASPERITY_KOKKOS_BACKEND "")
foreach(space IN ITEMS Cuda HIP SYCL OpenMPTarget OpenACC OpenMP Threads HPX Serial)
  string(TOUPPER "${space}" upper)
  file(STRINGS "${ASPERITY_KOKKOS_CONFIG}" enabled REGEX "^#define KOKKOS_ENABLE_${upper}$")
  if(enabled)
    set(ASPERITY_KOKKOS_BACKEND "${space}")
    break()
  endif()
endforeach()
message(STATUS
  "Kokkos ${ASPERITY_KOKKOS_VERSION} with ${ASPERITY_KOKKOS_BACKEND}: ${ASPERITY_KOKKOS_CONFIG}")
if(ASPERITY_BACKEND AND NOT ASPERITY_BACKEND STREQUAL ASPERITY_KOKKOS_BACKEND)
  message(FATAL_ERROR "ASPERITY_BACKEND is ${ASPERITY_BACKEND}, but the Kokkos found "
    "(${ASPERITY_KOKKOS_VERSION}, ${ASPERITY_KOKKOS_CONFIG}) runs on ${ASPERITY_KOKKOS_BACKEND}. "
    "Give another one by Trilinos_ROOT or, with ASPERITY_KERNELS_ONLY, Kokkos_ROOT; "
    "docs/cost/backends.md says how to build one. Debian's runs on Serial.")
endif()

# Trilinos 13 configures Kokkos by variables; its target names an include directory that does not
# exist. The target that other versions export works.
if(TARGET Kokkos::kokkos AND NOT Kokkos_PACKAGE_LIST)
  add_library(Asperity::Kokkos ALIAS Kokkos::kokkos)
else()
  find_library(ASPERITY_KOKKOS_CORE NAMES kokkoscore trilinos_kokkoscore NO_DEFAULT_PATH
    HINTS ${Kokkos_LIBRARY_DIRS} ${Trilinos_LIBRARY_DIRS} REQUIRED)
  add_library(Asperity::Kokkos INTERFACE IMPORTED)
  if(Trilinos_FOUND)
    target_include_directories(Asperity::Kokkos SYSTEM INTERFACE ${Trilinos_INCLUDE_DIRS})
  else()
    target_include_directories(Asperity::Kokkos SYSTEM INTERFACE ${Kokkos_INCLUDE_DIRS})
  endif()
  target_link_libraries(Asperity::Kokkos INTERFACE ${ASPERITY_KOKKOS_CORE} ${CMAKE_DL_LIBS})
  if(ASPERITY_KOKKOS_BACKEND STREQUAL "OpenMP")
    find_package(OpenMP REQUIRED COMPONENTS CXX)
    target_link_libraries(Asperity::Kokkos INTERFACE OpenMP::OpenMP_CXX)
  endif()
endif()

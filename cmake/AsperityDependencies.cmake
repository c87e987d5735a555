# Finds the libraries that the headers of the packages include; AsperityPrivateDependencies.cmake
# finds those that only their sources include. Each gets one target Asperity::<Library>. The
# installed AsperityConfig.cmake includes this file.
if(TARGET Asperity::Trilinos)
  return()
endif()

find_package(MPI REQUIRED COMPONENTS C CXX)

# Trilinos 14 and newer exports targets; 13 only sets variables. Trilinos::all_libs cannot be used:
# it names the targets of all packages, also of those that are not requested and not installed.
find_package(Trilinos REQUIRED COMPONENTS Tpetra Belos MueLu Teuchos Kokkos)
add_library(Asperity::Trilinos INTERFACE IMPORTED)
if(TARGET Trilinos::all_selected_libs)
  target_link_libraries(Asperity::Trilinos INTERFACE Trilinos::all_selected_libs MPI::MPI_CXX)
else()
  target_include_directories(Asperity::Trilinos SYSTEM INTERFACE
    ${Trilinos_INCLUDE_DIRS} ${Trilinos_TPL_INCLUDE_DIRS})
  target_link_directories(Asperity::Trilinos INTERFACE ${Trilinos_LIBRARY_DIRS})
  target_link_libraries(Asperity::Trilinos INTERFACE ${Trilinos_LIBRARIES} MPI::MPI_CXX)
endif()

include("${CMAKE_CURRENT_LIST_DIR}/AsperityKokkos.cmake")
if(ASPERITY_KOKKOS_BACKEND STREQUAL "OpenMP" AND TARGET OpenMP::OpenMP_CXX)
  target_link_libraries(Asperity::Trilinos INTERFACE OpenMP::OpenMP_CXX)
endif()

set(HDF5_PREFER_PARALLEL ON)
find_package(HDF5 REQUIRED COMPONENTS C)
if(NOT HDF5_IS_PARALLEL)
  message(FATAL_ERROR "HDF5 was found without MPI. On Debian: apt-get install libhdf5-openmpi-dev")
endif()
add_library(Asperity::HDF5 INTERFACE IMPORTED)
target_include_directories(Asperity::HDF5 SYSTEM INTERFACE ${HDF5_C_INCLUDE_DIRS})
# Of a target only what is linked: what is compiled with its macros (HDF5 2 has _FILE_OFFSET_BITS,
# the default on 64 bits) cannot share precompiled headers.
set(hdf5_libraries "")
foreach(library IN LISTS HDF5_C_LIBRARIES)
  if(TARGET ${library})
    set(library "$<LINK_ONLY:${library}>")
  endif()
  list(APPEND hdf5_libraries "${library}")
endforeach()
target_link_libraries(Asperity::HDF5 INTERFACE ${hdf5_libraries} MPI::MPI_C)

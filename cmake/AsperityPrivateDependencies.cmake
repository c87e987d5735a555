# Finds the libraries that no header of a package includes. Programs that link static libraries of
# Asperity need them, too.
if(TARGET Asperity::METIS)
  return()
endif()

find_path(METIS_INCLUDE_DIR metis.h REQUIRED)
find_library(METIS_LIBRARY metis REQUIRED)
add_library(Asperity::METIS INTERFACE IMPORTED)
target_include_directories(Asperity::METIS SYSTEM INTERFACE ${METIS_INCLUDE_DIR})
target_link_libraries(Asperity::METIS INTERFACE ${METIS_LIBRARY})

find_package(muparser 2.3.3 REQUIRED) # functions with data of their own
find_package(CLI11 REQUIRED)
# No version is given here, because Eigen 5 is refused where version 3 is requested.
find_package(Eigen3 REQUIRED NO_MODULE)
if(Eigen3_VERSION VERSION_LESS 3.3)
  message(FATAL_ERROR "Asperity needs Eigen 3.3 or newer; ${Eigen3_DIR} has version "
    "${Eigen3_VERSION}.")
endif()

if(ASPERITY_ENABLE_TESTS)
  find_package(GTest REQUIRED)
endif()

# Only asperity-mesh uses Gmsh and CGAL, so that their licence (GPL) does not apply to the rest of
# Asperity.
if(ASPERITY_ENABLE_MESH_TOOL)
  find_path(GMSH_INCLUDE_DIR gmsh.h)
  find_library(GMSH_LIBRARY gmsh)
  if(GMSH_INCLUDE_DIR AND GMSH_LIBRARY)
    add_library(Asperity::Gmsh INTERFACE IMPORTED)
    target_include_directories(Asperity::Gmsh SYSTEM INTERFACE ${GMSH_INCLUDE_DIR})
    target_link_libraries(Asperity::Gmsh INTERFACE ${GMSH_LIBRARY})
  else()
    message(STATUS "The Gmsh library was not found; asperity-mesh is left out. "
      "On Debian: apt-get install libgmsh-dev")
  endif()
  # Only headers; their own CMake file would change the flags of this build.
  find_path(CGAL_INCLUDE_DIR CGAL/version.h)
  find_library(GMP_LIBRARY gmp)
  find_library(MPFR_LIBRARY mpfr)
  if(CGAL_INCLUDE_DIR AND GMP_LIBRARY AND MPFR_LIBRARY)
    add_library(Asperity::CGAL INTERFACE IMPORTED)
    target_include_directories(Asperity::CGAL SYSTEM INTERFACE ${CGAL_INCLUDE_DIR})
    target_link_libraries(Asperity::CGAL INTERFACE ${GMP_LIBRARY} ${MPFR_LIBRARY})
  elseif(TARGET Asperity::Gmsh)
    message(STATUS "CGAL was not found; asperity-mesh has no command build. "
      "On Debian: apt-get install libcgal-dev")
  endif()
endif()

# What asperity-mesh reads surfaces with; it also works without them.
if(TARGET Asperity::Gmsh)
  find_package(ZLIB QUIET)
  find_package(PROJ CONFIG QUIET)
  if(NOT TARGET PROJ::proj)
    message(STATUS "PROJ was not found; asperity-mesh has no projections. "
      "On Debian: apt-get install libproj-dev")
  endif()
endif()

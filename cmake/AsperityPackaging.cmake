# `cpack -G DEB` in the build folder makes packages for the release of Debian that it runs on:
#
#   asperity           programs, libraries, the package for Python, decks, examples
#   asperity-mesh      the mesh tool alone, which uses Gmsh and CGAL (GPL 3)
#   libasperity-dev    headers, and the files that find_package(Asperity) reads
#   asperity-doc       the documents
#
set(ASPERITY_PACKAGE_CONTACT "The Asperity developers <asperity@localhost>" CACHE STRING
  "Maintainer in packages for Debian: name and address")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME asperity)
set(CPACK_PACKAGE_VENDOR "The Asperity developers")
set(CPACK_PACKAGE_CONTACT "${ASPERITY_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL programs headers documents)
if(TARGET asperity-mesh)
  list(APPEND CPACK_COMPONENTS_ALL mesh_tool)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # the shared libraries of others, by dpkg-shlibdeps
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${PROJECT_BINARY_DIR}")
set(same_version "(= ${PROJECT_VERSION})")

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME asperity)
set(CPACK_COMPONENT_PROGRAMS_DESCRIPTION "Programs, libraries, decks and the Python package.")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS
  "openmpi-bin, python3, python3-h5py, python3-numpy, python3-matplotlib")

set(CPACK_DEBIAN_MESH_TOOL_PACKAGE_NAME asperity-mesh)
set(CPACK_COMPONENT_MESH_TOOL_DESCRIPTION
  "Makes and converts meshes; uses Gmsh and CGAL (GPL 3).")
set(CPACK_DEBIAN_MESH_TOOL_PACKAGE_DEPENDS "asperity ${same_version}")

# The packages that TrilinosConfig.cmake and the headers of Asperity need: those of quickstart.sh,
# by their names in this release.
execute_process(
  COMMAND bash -c ". cmake/quickstart_packages.sh; read_system; required_packages | select_of any"
  WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}" OUTPUT_VARIABLE required
  OUTPUT_STRIP_TRAILING_WHITESPACE)
string(REGEX MATCHALL "lib[a-z0-9-]+-dev" required "${required}")
list(TRANSFORM required PREPEND ", ")
string(REPLACE ";" "" required "${required}")
set(CPACK_DEBIAN_HEADERS_PACKAGE_NAME libasperity-dev)
set(CPACK_DEBIAN_HEADERS_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_HEADERS_DESCRIPTION
  "Headers and CMake files, for laws and outputs of your own.")
set(CPACK_DEBIAN_HEADERS_PACKAGE_DEPENDS
  "asperity ${same_version}, g++, cmake, make | ninja-build${required}")
if(TARGET asperity-mesh)
  string(APPEND CPACK_DEBIAN_HEADERS_PACKAGE_DEPENDS ", asperity-mesh ${same_version}")
endif()

set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_NAME asperity-doc)
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOCUMENTS_PACKAGE_ARCHITECTURE all)
set(CPACK_COMPONENT_DOCUMENTS_DESCRIPTION
  "The manual as Markdown: models, examples, reference, validation.")
include(CPack)

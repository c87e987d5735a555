option(ASPERITY_ENABLE_TESTS "Build the tests" ON)
option(ASPERITY_ENABLE_MESH_TOOL "Build asperity-mesh, which links the Gmsh library (GPL)" ON)
option(ASPERITY_PRECOMPILED_HEADERS "Compile the headers of Trilinos once, for faster builds" ON)
# Off, so that the warnings of a compiler of the future stop nobody; quickstart.sh --strict sets it.
option(ASPERITY_WARNINGS_AS_ERRORS "Treat warnings in Asperity's own code as errors" OFF)

set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

find_program(ASPERITY_CCACHE ccache)
if(ASPERITY_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${ASPERITY_CCACHE}")
endif()

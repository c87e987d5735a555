# ASPERITY_BUILT_FROM: what `asperity --version` says about the build, as "commit 1a2b3c4d5e6f, GNU
# 12.2.0, Release, HDF5 1.10.8, Eigen 3.4.0". CMake runs again after a commit; changes that are not
# committed ("-dirty") are noticed only when CMake runs for another reason.
set(ASPERITY_BUILT_FROM "")
find_package(Git QUIET)
if(GIT_FOUND AND EXISTS "${PROJECT_SOURCE_DIR}/.git")
  execute_process(COMMAND "${GIT_EXECUTABLE}" describe --always --dirty --abbrev=12 --exclude "*"
    WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}" OUTPUT_VARIABLE commit
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    list(APPEND ASPERITY_BUILT_FROM "commit ${commit}")
  endif()
  if(EXISTS "${PROJECT_SOURCE_DIR}/.git/logs/HEAD")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
      "${PROJECT_SOURCE_DIR}/.git/logs/HEAD")
  endif()
endif()
list(APPEND ASPERITY_BUILT_FROM "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
if(CMAKE_BUILD_TYPE)
  list(APPEND ASPERITY_BUILT_FROM "${CMAKE_BUILD_TYPE}")
endif()
if(ASPERITY_SANITIZER)
  string(REPLACE "," " and " sanitizers "${ASPERITY_SANITIZER}")
  list(APPEND ASPERITY_BUILT_FROM "sanitizers ${sanitizers}")
endif()
foreach(library HDF5 Eigen3)
  if(${library}_VERSION)
    string(REGEX REPLACE "3$" "" name "${library}")
    list(APPEND ASPERITY_BUILT_FROM "${name} ${${library}_VERSION}")
  endif()
endforeach()
string(REPLACE ";" ", " ASPERITY_BUILT_FROM "${ASPERITY_BUILT_FROM}")

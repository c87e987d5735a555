# Configures, builds and tests packages/friction and multigrid alone in the folder BUILD;
# CONFIGURE: CMake's arguments.
foreach(command IN ITEMS "${CMAKE_COMMAND};${CONFIGURE};-B;${BUILD}"
    "${CMAKE_COMMAND};--build;${BUILD}"
    "${CMAKE_CTEST_COMMAND};--test-dir;${BUILD};--output-on-failure;--no-tests=error")
  execute_process(COMMAND ${command} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "status ${status} of: ${command}")
  endif()
endforeach()
file(STRINGS "${BUILD}/CMakeCache.txt" found REGEX "^(Trilinos_DIR|MPI_CXX_LIB_NAMES)[^=]*=/")
if(found)
  message(FATAL_ERROR "the kernels have looked for more than Kokkos and Eigen: ${found}")
endif()

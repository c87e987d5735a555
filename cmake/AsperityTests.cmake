# Main programs of the tests: tests/support/TestMain.cpp starts MPI and Kokkos before GoogleTest;
# KokkosTestMain.cpp, for packages without MPI, starts only Kokkos.
function(asperity_add_test_main target source)
  add_library(${target} OBJECT "${PROJECT_SOURCE_DIR}/tests/support/${source}")
  asperity_compile_options(${target})
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_link_libraries(${target} PUBLIC Asperity::Kokkos GTest::gtest ${ARGN})
endfunction()
asperity_add_test_main(asperity_kokkos_test_main KokkosTestMain.cpp asperity_portability)
if(NOT ASPERITY_KERNELS_ONLY)
  asperity_add_test_main(asperity_test_main TestMain.cpp MPI::MPI_CXX)
endif()

# Open MPI refuses to run as root, which is usual in containers, and its waiting ranks keep a core
# busy, which delays other ranks on that core. These options change both; other MPIs get no options.
# Open MPI's library hwloc writes an error to stderr if there is no /sys, unless HWLOC_HIDE_ERRORS
# is set. The tests start many short programs, and the time for MPI_Init matters. It looks for
# networks, which one machine does not need (self and vader use its memory), and without mpirun it
# starts a daemon. Both are turned off. Without mpirun and daemon all programs create and remove a
# temporary folder of the same name, so that two that start at the same time may fail. They do not
# need it and make none; mpirun needs it, and gets the opposite option.
set(ASPERITY_TEST_ENVIRONMENT OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  HWLOC_HIDE_ERRORS=2 OMPI_MCA_pml=ob1 OMPI_MCA_btl=self,vader OMPI_MCA_ess_singleton_isolated=1
  OMPI_MCA_orte_create_session_dirs=0)
list(APPEND ASPERITY_TEST_ENVIRONMENT ${asperity_sanitizer_environment}
  ASPERITY_TEST_TIME_FACTOR=${ASPERITY_TEST_TIME_FACTOR})
set(ASPERITY_MPI_OPTIONS "")
set(mpiexec_version "")
if(MPIEXEC_EXECUTABLE)
  execute_process(COMMAND "${MPIEXEC_EXECUTABLE}" --version
    OUTPUT_VARIABLE mpiexec_version ERROR_QUIET)
endif()
if(mpiexec_version MATCHES "Open MPI|OpenRTE")
  set(ASPERITY_MPI_OPTIONS --oversubscribe --bind-to none --mca mpi_yield_when_idle 1
    --mca orte_create_session_dirs 1)
endif()

# Builds the programs of the tests with the label `quick`, which continuous integration also runs in
# the preset `debug`.
add_custom_target(asperity_quick_tests)

asperity_add_precompiled_headers(tests HEADERS <gtest/gtest.h> LIBRARIES GTest::gtest)

# asperity_time_limit(<test> <seconds>): the limit for an ordinary build, times
# ASPERITY_TEST_TIME_FACTOR.
function(asperity_time_limit name seconds)
  math(EXPR seconds "${seconds} * ${ASPERITY_TEST_TIME_FACTOR}")
  set_tests_properties(${name} PROPERTIES TIMEOUT ${seconds})
endfunction()

# asperity_not_with_sanitizer(<sanitizer> <test> <reason>): disables a test, which ctest then lists
# as disabled, in a build with a sanitizer under which it cannot work.
function(asperity_not_with_sanitizer sanitizer name reason)
  if(ASPERITY_SANITIZER MATCHES "${sanitizer}")
    message(STATUS "${name} is left out with the sanitizer ${sanitizer}: ${reason}")
    set_tests_properties(${name} PROPERTIES DISABLED TRUE)
  endif()
endfunction()

# Stores the names of the packages that a test has as labels (`ctest -L '^tnnmg$'`). A unit test has
# the name of its folder; others have the given names and those in the variable `tested_packages`,
# which folders set whose tests run the whole program.
function(asperity_package_labels result level)
  set(labels ${ARGN} ${tested_packages})
  if(level STREQUAL "unit")
    get_filename_component(labels "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  endif()
  set(${result} ${labels} PARENT_SCOPE)
endfunction()

# asperity_add_test(<level>.<package>.<Name> SOURCES <file>... PACKAGES <package>...
#                   [LIBRARIES <target>...] [RANKS <n>...] [LABELS <label>...] [TIMEOUT <seconds>]
#                   [SEPARATE <file>...])
#
# A GoogleTest program, run once for each number of ranks as <level>.<package>.<Name>_MPI_<n>.
# Labels: the level, packages, and short (the default), medium or long. Continuous integration also
# runs tests with the label quick in the preset `debug`. In a unity build the sources of a program
# are compiled together, but for SEPARATE: those whose names are also in others of its sources.
function(asperity_add_test name)
  cmake_parse_arguments(TEST "" "TIMEOUT" "SOURCES;PACKAGES;LIBRARIES;RANKS;LABELS;SEPARATE"
    ${ARGN})
  if(NOT TEST_SOURCES)
    message(FATAL_ERROR "asperity_add_test(${name}): SOURCES is empty")
  endif()
  if(TEST_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "asperity_add_test(${name}): unknown arguments ${TEST_UNPARSED_ARGUMENTS}")
  endif()
  string(REGEX MATCH "^[a-z]+" level "${name}")
  if(NOT TEST_RANKS)
    set(TEST_RANKS 1)
  endif()
  if(NOT TEST_LABELS)
    set(TEST_LABELS short)
  endif()
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 300)
  endif()
  add_executable(${name} ${TEST_SOURCES})
  if(TEST_SEPARATE)
    set_source_files_properties(${TEST_SEPARATE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
  asperity_compile_options(${name})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/tests")
  asperity_link_packages(${name} PRIVATE ${TEST_PACKAGES})
  asperity_sanitize_program(${name})
  list(GET TEST_PACKAGES 0 first_package)
  list(LENGTH TEST_PACKAGES num_packages)
  if(num_packages EQUAL 1 AND first_package IN_LIST asperity_kernel_packages)
    target_link_libraries(${name} PRIVATE asperity_kokkos_test_main ${TEST_LIBRARIES})
  else()
    target_link_libraries(${name} PRIVATE asperity_test_main ${TEST_LIBRARIES})
    asperity_use_precompiled_headers(${name} tests)
  endif()
  if("quick" IN_LIST TEST_LABELS)
    add_dependencies(asperity_quick_tests ${name})
  endif()
  asperity_package_labels(packages ${level} ${TEST_PACKAGES})
  foreach(ranks IN LISTS TEST_RANKS)
    asperity_add_mpi_command(${name}_MPI_${ranks} RANKS ${ranks} COMMAND $<TARGET_FILE:${name}>)
    set_tests_properties(${name}_MPI_${ranks} PROPERTIES
      LABELS "${level};${packages};${TEST_LABELS}" PROCESSORS ${ranks})
    asperity_time_limit(${name}_MPI_${ranks} ${TEST_TIMEOUT})
  endforeach()
endfunction()

# asperity_add_mpi_command(<name> RANKS <n> COMMAND <command>...): a test that runs COMMAND, under
# mpirun for more than one rank. Labels and time limit are set by the caller.
function(asperity_add_mpi_command name)
  cmake_parse_arguments(RUN "" "RANKS" "COMMAND" ${ARGN})
  if(RUN_RANKS GREATER 1)
    add_test(NAME ${name} COMMAND ${MPIEXEC_EXECUTABLE} ${ASPERITY_MPI_OPTIONS}
      ${MPIEXEC_NUMPROC_FLAG} ${RUN_RANKS} ${RUN_COMMAND})
  else()
    add_test(NAME ${name} COMMAND ${RUN_COMMAND})
  endif()
  set_tests_properties(${name} PROPERTIES ENVIRONMENT "${ASPERITY_TEST_ENVIRONMENT}")
endfunction()

# asperity_add_python_test(<level>.<name> SCRIPT <file> [ARGUMENTS <argument>...]
#                          [ENVIRONMENT <name=value>...] [LABELS <label>...]
#                          [TIMEOUT <seconds>] [PROCESSORS <n>] [CONFIGURATIONS <name>...])
#
# Runs a Python script in a folder of its own, which may contain files of the last run. Its
# environment has ASPERITY_SOURCE_DIR, ASPERITY_BUILD_DIR (programs in drivers/), ASPERITY_MPIEXEC
# (the command before the number of ranks) and tests/support on PYTHONPATH.
# With CONFIGURATIONS it runs only if `ctest -C` names one of them. PROCESSORS: the cores that it
# keeps busy on average; a script that waits, or runs most programs on one rank, needs one only. A
# script that starts more than two ranks says how many: ranks that share cores with another test
# wait for each other, and four ranks on two busy cores run 35 times longer.
function(asperity_add_python_test name)
  cmake_parse_arguments(TEST "" "SCRIPT;TIMEOUT;PROCESSORS"
    "ARGUMENTS;ENVIRONMENT;LABELS;CONFIGURATIONS" ${ARGN})
  if(NOT TEST_SCRIPT OR TEST_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "asperity_add_python_test(${name}): SCRIPT '${TEST_SCRIPT}' is missing, or "
      "unknown arguments '${TEST_UNPARSED_ARGUMENTS}'")
  endif()
  if(NOT ASPERITY_PYTHON)
    message(FATAL_ERROR "Tests need Python 3: set ASPERITY_PYTHON, or ASPERITY_ENABLE_TESTS=OFF")
  endif()
  get_filename_component(script "${TEST_SCRIPT}" ABSOLUTE)
  if(NOT EXISTS "${script}")
    message(FATAL_ERROR "asperity_add_python_test(${name}): there is no ${script}")
  endif()
  string(REGEX MATCH "^[a-z]+" level "${name}")
  if(NOT TEST_LABELS)
    set(TEST_LABELS short)
  endif()
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 300)
  endif()
  if(NOT TEST_PROCESSORS)
    set(TEST_PROCESSORS 1)
  endif()
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/${name}")
  file(MAKE_DIRECTORY "${folder}")
  set(configurations "")
  if(TEST_CONFIGURATIONS)
    set(configurations CONFIGURATIONS ${TEST_CONFIGURATIONS})
  endif()
  add_test(NAME ${name} COMMAND "${ASPERITY_PYTHON}" "${script}" ${TEST_ARGUMENTS}
    WORKING_DIRECTORY "${folder}" ${configurations})
  asperity_package_labels(packages ${level})
  set(mpiexec "${MPIEXEC_EXECUTABLE} ${ASPERITY_MPI_OPTIONS} ${MPIEXEC_NUMPROC_FLAG}")
  string(REPLACE ";" " " mpiexec "${mpiexec}")
  set_tests_properties(${name} PROPERTIES
    LABELS "${level};${packages};${TEST_LABELS}" PROCESSORS ${TEST_PROCESSORS}
    ENVIRONMENT "${ASPERITY_TEST_ENVIRONMENT};ASPERITY_SOURCE_DIR=${PROJECT_SOURCE_DIR};\
ASPERITY_BUILD_DIR=${PROJECT_BINARY_DIR};ASPERITY_MPIEXEC=${mpiexec};PYTHONDONTWRITEBYTECODE=1;\
PYTHONPATH=${PROJECT_SOURCE_DIR}/tests/support;${TEST_ENVIRONMENT}")
  asperity_time_limit(${name} ${TEST_TIMEOUT})
endfunction()

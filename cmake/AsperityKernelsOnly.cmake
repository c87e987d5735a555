# ASPERITY_KERNELS_ONLY: packages/friction and multigrid, the packages that they include, and their
# tests, with Kokkos 3.4 or newer and Eigen. Neither Trilinos nor MPI is looked for, and nothing is
# installed.
set(ASPERITY_ENABLE_INSTALL OFF)
set(ASPERITY_PRECOMPILED_HEADERS OFF)
include(AsperityKokkos)
if(ASPERITY_SEPARATE_MEMORY) # kernels have memory that the host must not touch
  add_compile_options(-DASPERITY_MEMORY_SPACE=asperity::test::SeparateMemory
    "SHELL:-include ${PROJECT_SOURCE_DIR}/tests/support/SeparateMemory.hpp")
endif()
include(AsperityPrecompiled)
include(AsperityInstall)
include(AsperityTargets)

find_package(Eigen3 REQUIRED NO_MODULE)
include(AsperityKernelPackages)

if(ASPERITY_ENABLE_TESTS)
  enable_testing()
  find_package(GTest REQUIRED)
  include(AsperityTests)
  foreach(folder IN LISTS asperity_kernel_packages)
    add_subdirectory(tests/unit/${folder})
  endforeach()
  add_subdirectory(tests/verification/friction_kernel)
endif()

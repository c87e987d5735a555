# The packages that stand on Kokkos alone: they are built without Trilinos and MPI, also by
# themselves (ASPERITY_KERNELS_ONLY).
set(asperity_kernel_packages portability registry friction multigrid)
asperity_add_package(portability LIBRARIES Asperity::Kokkos)
asperity_add_package(registry PACKAGES portability LIBRARIES Asperity::Kokkos)
asperity_add_package(friction PACKAGES registry portability LIBRARIES Asperity::Kokkos)
asperity_add_package(multigrid PACKAGES registry portability LIBRARIES Asperity::Kokkos
  PRIVATE_LIBRARIES Eigen3::Eigen)

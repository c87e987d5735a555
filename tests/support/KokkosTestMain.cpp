#include "portability/Backend.hpp"

#include <Kokkos_Core.hpp>
#include <gtest/gtest.h>

#include <iostream>

// Starts Kokkos around GoogleTest, for the packages that stand on Kokkos alone.
int main(int argc, char** argv)
{
  Kokkos::ScopeGuard kokkos(argc, argv);
#ifdef ASPERITY_MEMORY_SPACE
  asperity::test::watchKernels();
#endif
  std::cout << "Kokkos " << asperity::kokkosVersion() << ", " << asperity::describeBackend()
            << '\n';
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}

#include "portability/Renamed.hpp"

#include "portability/Spaces.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace asperity;

struct OldMatrix // Trilinos 13.2
{
  int getNodeNumRows() const { return 3; }
  int getNodeNumEntries() const { return 7; }
};

struct NewMatrix // Trilinos 16
{
  int getLocalNumRows() const { return 4; }
  int getLocalNumEntries() const { return 9; }
};

struct MatrixBetween : OldMatrix, NewMatrix // Trilinos 14: the old name is deprecated
{
};

TEST(Renamed, TakesTheNewNameWhereThereIsOne)
{
  EXPECT_EQ(numLocalRows(OldMatrix()), 3u);
  EXPECT_EQ(numLocalEntries(OldMatrix()), 7u);
  EXPECT_EQ(numLocalRows(NewMatrix()), 4u);
  EXPECT_EQ(numLocalEntries(NewMatrix()), 9u);
  EXPECT_EQ(numLocalRows(MatrixBetween()), 4u);
}

double mathInAKernel()
{
  double result = 0;
  Kokkos::parallel_reduce(
    "asperity::test::math", Kokkos::RangePolicy<ExecutionSpace>(0, 1),
    KOKKOS_LAMBDA(int, double& sum) { sum += math::sqrt(2.) + math::log1p(3.); }, result);
  return result;
}

TEST(Renamed, MathRunsInKernels)
{
  EXPECT_NEAR(mathInAKernel(), std::sqrt(2.) + std::log1p(3.), 4 * 2.2e-16);
}
} // namespace

#include "portability/Backend.hpp"
#include "portability/Spaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace asperity;

// CMake reads the backend and the version from a header; the program asks Kokkos.
TEST(Backend, IsTheOneThatCMakeRead)
{
  EXPECT_EQ(backendName(), ASPERITY_KOKKOS_BACKEND);
  EXPECT_EQ(kokkosVersion(), ASPERITY_KOKKOS_VERSION);
}

TEST(Backend, IsDescribedWithItsThreads)
{
  const auto text = describeBackend();
  EXPECT_EQ(text.rfind(backendName(), 0), 0u) << text;
  if (kernels_run_serially) {
    EXPECT_EQ(text, "Serial");
  } else if (kernels_run_on_host) {
    // Static in Kokkos 3 alone. NOLINTNEXTLINE(readability-static-accessed-through-instance)
    const auto threads = std::to_string(ExecutionSpace().concurrency());
    EXPECT_NE(text.find(" with " + threads + " thread"), std::string::npos) << text;
  }
}

// 0 + 1 + ... + (count - 1), over an array in the memory of the backend. In a function of its own,
// since device lambdas may not stand in the private function that TEST makes.
int sumOfNumbers(int count)
{
  const Kokkos::View<int*, MemorySpace> hits("asperity::test::hits", count);
  Kokkos::parallel_for(
    "asperity::test::count", Kokkos::RangePolicy<ExecutionSpace>(0, count),
    KOKKOS_LAMBDA(int i) { hits(i) += i; });
  int sum = 0;
  Kokkos::parallel_reduce(
    "asperity::test::sum", Kokkos::RangePolicy<ExecutionSpace>(0, count),
    KOKKOS_LAMBDA(int i, int& part) { part += hits(i); }, sum);
  return sum;
}

TEST(Backend, RunsKernels) { EXPECT_EQ(sumOfNumbers(1000), 499500); }

// Kokkos takes its own options out of the command line and leaves those that it does not know.
TEST(Backend, KnowsTheNameOfTheThreadsOption)
{
  const auto options = kokkosOptions();
  const auto has = [&](std::string const& name) {
    return std::find(options.begin(), options.end(), name) != options.end();
  };
  EXPECT_NE(has("--kokkos-threads"), has("--kokkos-num-threads"));
}
} // namespace

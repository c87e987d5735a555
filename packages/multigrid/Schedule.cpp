#include "multigrid/Schedule.hpp"

namespace asperity::multigrid
{
int Schedule::numThreads() { return Kokkos::DefaultHostExecutionSpace().concurrency(); }
} // namespace asperity::multigrid

#pragma once

#include <Kokkos_Core.hpp>

#include <type_traits>

// Where kernels run and where the data of nodes, rows and cells lie: the one choice for all
// packages. base/program/MpiScope.cpp asserts that Tpetra uses the same spaces.
namespace asperity
{
using ExecutionSpace = Kokkos::DefaultExecutionSpace;
#ifdef ASPERITY_MEMORY_SPACE // of tests: tests/support/SeparateMemory.hpp
using MemorySpace = ASPERITY_MEMORY_SPACE;
#else
using MemorySpace = ExecutionSpace::memory_space;
#endif
using RangePolicy = Kokkos::RangePolicy<ExecutionSpace>; // for (begin, end)

// Kernels run on the host's own cores and memory: serially or on threads, but not on a device.
inline constexpr bool kernels_run_on_host =
  std::is_same<ExecutionSpace, Kokkos::DefaultHostExecutionSpace>::value &&
  std::is_same<MemorySpace, ExecutionSpace::memory_space>::value;

// Kernels run on one thread, so that a loop which is serial by nature costs nothing.
#ifdef KOKKOS_ENABLE_SERIAL
inline constexpr bool kernels_run_serially = std::is_same<ExecutionSpace, Kokkos::Serial>::value;
#else
inline constexpr bool kernels_run_serially = false;
#endif
} // namespace asperity

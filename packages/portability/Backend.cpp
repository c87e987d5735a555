#include "portability/Backend.hpp"

#include "portability/Spaces.hpp"

namespace asperity
{
std::string backendName() { return ExecutionSpace::name(); }

std::string kokkosVersion()
{
  return std::to_string(KOKKOS_VERSION / 10000) + '.' + std::to_string(KOKKOS_VERSION / 100 % 100) +
         '.' + std::to_string(KOKKOS_VERSION % 100);
}

std::string describeBackend()
{
#ifdef KOKKOS_ENABLE_CUDA
  cudaDeviceProp properties;
  if (cudaGetDeviceProperties(&properties, ExecutionSpace().cuda_device()) == cudaSuccess) {
    return backendName() + " on " + properties.name;
  }
#endif
  if (kernels_run_serially || !kernels_run_on_host) {
    return backendName();
  }
  // Static in Kokkos 3 alone. NOLINTNEXTLINE(readability-static-accessed-through-instance)
  const auto threads = ExecutionSpace().concurrency();
  return backendName() + " with " + std::to_string(threads) +
         (threads == 1 ? " thread" : " threads");
}

std::vector<std::string> kokkosOptions()
{
#if KOKKOS_VERSION >= 30700
  return {"--kokkos-num-threads",      "--kokkos-device-id",
          "--kokkos-map-device-id-by", "--kokkos-disable-warnings",
          "--kokkos-tune-internals",   "--kokkos-print-configuration",
          "--kokkos-tools-libs",       "--kokkos-tools-args",
          "--kokkos-tools-help",       "--kokkos-help"};
#else
  return {"--kokkos-threads",       "--kokkos-numa",           "--kokkos-device-id",
          "--kokkos-num-devices",   "--kokkos-tune-internals", "--kokkos-disable-warnings",
          "--kokkos-tools-library", "--kokkos-tools-args",     "--kokkos-tools-help",
          "--kokkos-help"};
#endif
}
} // namespace asperity

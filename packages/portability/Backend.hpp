#pragma once

#include <string>
#include <vector>

// What kernels run on, in words. Kokkos must be running for describeBackend().
namespace asperity
{
// "Serial", "OpenMP", "Cuda", ...: the name of the default execution space.
std::string backendName();

// "3.4.1"
std::string kokkosVersion();

// "OpenMP with 2 threads", "Serial", "Cuda on NVIDIA H100".
std::string describeBackend();

// The options that this version of Kokkos takes, without their values: "--kokkos-threads", ...
std::vector<std::string> kokkosOptions();
} // namespace asperity

#pragma once

#include "base/Types.hpp"

#include <iosfwd>
#include <string>
#include <vector>

namespace asperity::scenario
{
// What the program runs on, for the first lines of the log and for `asperity --version`:
//
//   Asperity 0.2.0 on Serial, 2 ranks.
//   Kokkos 3.4.1, Trilinos 13.2, Open MPI v4.1.4.
//   Built from commit <hash>, GNU 12.2.0, Release, HDF5 1.10.8, Eigen 3.4.0.
//   Machine: node17, 16 cores of AMD EPYC 7B13, Linux 6.1.0-18-amd64 x86_64.
//
// The execution space, threads or device, and the machine, are those of this rank.
std::vector<std::string> describeEnvironment(Communicator const& communicator);

// The same, line by line.
void printEnvironment(Communicator const& communicator, std::ostream& out);
} // namespace asperity::scenario

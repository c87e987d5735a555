#pragma once

#include "base/Types.hpp"

#include <iosfwd>
#include <string>
#include <vector>

namespace asperity::scenario
{
// What the program runs on, for the first lines of the log and for `asperity --version`:
//
//   Asperity 0.1.0 on Serial, 2 ranks.
//   Kokkos 3.4.1, Trilinos 13.2, Open MPI v4.1.4.
//
// The execution space, threads or device are those of this rank.
std::vector<std::string> describeEnvironment(Communicator const& communicator);

// The same, line by line.
void printEnvironment(Communicator const& communicator, std::ostream& out);
} // namespace asperity::scenario

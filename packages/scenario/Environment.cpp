#include "scenario/Environment.hpp"

#include "portability/Backend.hpp"

#include <Trilinos_version.h>
#include <mpi.h>

#include <algorithm>
#include <ostream>

namespace asperity::scenario
{
namespace
{
// "Open MPI v4.1.4" of "Open MPI v4.1.4, package: Debian OpenMPI, ident: ..."; "MPICH Version: 4.0"
// of several lines.
std::string mpiVersion()
{
  std::string text(MPI_MAX_LIBRARY_VERSION_STRING, '\0');
  int length = 0;
  MPI_Get_library_version(text.data(), &length);
  text.resize(static_cast<std::size_t>(length));
  text.resize(std::min(text.size(), text.find_first_of(",\n")));
  for (auto tab = text.find('\t'); tab != std::string::npos; tab = text.find('\t')) {
    text.replace(tab, 1, " ");
  }
  return text;
}
} // namespace

std::vector<std::string> describeEnvironment(Communicator const& communicator)
{
  const int ranks = communicator.getSize();
  return {std::string("Asperity ") + ASPERITY_VERSION + " on " + describeBackend() + ", " +
            std::to_string(ranks) + (ranks == 1 ? " rank." : " ranks."),
          "Kokkos " + kokkosVersion() + ", Trilinos " + TRILINOS_VERSION_STRING + ", " +
            mpiVersion() + "."};
}

void printEnvironment(Communicator const& communicator, std::ostream& out)
{
  for (auto const& line : describeEnvironment(communicator)) {
    out << line << '\n';
  }
}
} // namespace asperity::scenario

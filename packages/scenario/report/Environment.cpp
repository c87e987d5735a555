#include "scenario/report/Environment.hpp"

#include "base/Text.hpp"
#include "portability/Backend.hpp"

#include <Trilinos_version.h>
#include <mpi.h>
#include <sys/utsname.h>

#include <algorithm>
#include <fstream>
#include <ostream>
#include <thread>

namespace asperity::scenario
{
namespace
{
// The first words or line of what MPI says of itself: "Open MPI v4.1.4" of "Open MPI v4.1.4,
// package: Debian OpenMPI, ident: ...", "MPICH Version: 4.0" of several lines.
std::string mpiVersion()
{
  std::string text(MPI_MAX_LIBRARY_VERSION_STRING, '\0');
  int length = 0;
  MPI_Get_library_version(text.data(), &length);
  text.resize(static_cast<std::size_t>(length));
  text.resize(std::min(text.size(), text.find_first_of(",\n")));
  std::replace(text.begin(), text.end(), '\t', ' ');
  return text;
}

// The name in Linux's /proc/cpuinfo, such as "AMD EPYC 7B13"; "" on other systems.
std::string processor()
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) {
      return line.substr(colon + 2);
    }
  }
  return "";
}

// "Machine: node17, 16 cores of AMD EPYC 7B13, Linux 6.1.0-18-amd64 x86_64."
std::string describeMachine()
{
  utsname system{};
  if (::uname(&system) != 0) {
    return "Machine: unknown.";
  }
  const std::string name = processor();
  return std::string("Machine: ") + system.nodename + ", " +
         std::to_string(std::thread::hardware_concurrency()) + " cores" +
         (name.empty() ? "" : " of " + name) + ", " + system.sysname + ' ' + system.release + ' ' +
         system.machine + ".";
}
} // namespace

std::vector<std::string> describeEnvironment(Communicator const& communicator)
{
  return {std::string("Asperity ") + ASPERITY_VERSION + " on " + describeBackend() + ", " +
            counted(communicator.getSize(), "rank") + '.',
          "Kokkos " + kokkosVersion() + ", Trilinos " + TRILINOS_VERSION_STRING + ", " +
            mpiVersion() + ".",
          std::string("Built from ") + ASPERITY_BUILT_FROM + ".", describeMachine()};
}

void printEnvironment(Communicator const& communicator, std::ostream& out)
{
  for (auto const& line : describeEnvironment(communicator)) {
    out << line << '\n';
  }
}
} // namespace asperity::scenario

#pragma once

#include "base/Types.hpp"

#include <array>
#include <csignal>
#include <string>

namespace asperity
{
// While it lives, SIGTERM, SIGINT, SIGHUP (the user logs out), SIGUSR1 and SIGUSR2 (a queue's
// warnings, which mpirun passes on), SIGXCPU (the soft limit of CPU time) and SIGPIPE (nobody reads
// the output) set a flag instead of ending the process, so that a run can write a last checkpoint.
// Some queues use SIGXCPU for the limit of memory or wall time. A second SIGINT ends the process at
// once; SIGXCPU comes again every second of CPU time until the hard limit kills. SIGHUP and
// SIGPIPE stay ignored if they are ignored now, as under nohup, or were ignored when
// noteIgnoredSignals was called. Only one object may exist at a time; its destructor restores the
// earlier handlers.
class StopSignals
{
public:
  StopSignals();
  ~StopSignals();
  StopSignals(StopSignals const&) = delete;
  StopSignals& operator=(StopSignals const&) = delete;

  // The last signal this rank received, 0 if none.
  int received() const;

  struct Agreed
  {
    int signal;  // the largest number that any rank received, 0 if none
    bool wished; // by any rank; unknown if there is a signal
  };
  // The signals that the ranks received, and whether a rank wishes something else, such as a
  // checkpoint; the same on all ranks. It takes one reduction, since it is called after every step.
  // Collective.
  Agreed agreed(bool wish, Communicator const& communicator) const;

private:
  static constexpr std::array<int, 7> watched = {SIGTERM, SIGINT,  SIGHUP, SIGUSR1,
                                                 SIGUSR2, SIGXCPU, SIGPIPE};
  std::array<struct sigaction, watched.size()> previous_;
};

// Notes whether SIGHUP and SIGPIPE are ignored now. For the loader's .preinit_array, before the
// libraries' own constructors: UCX, which comes with Open MPI 5, puts a handler of its own in the
// place of nohup's. The arguments are main's and the environment; they are not used.
void noteIgnoredSignals(int, char**, char**);

// "SIGTERM", or the number of a signal that is not watched.
std::string signalName(int number);
} // namespace asperity

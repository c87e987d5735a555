#include "base/program/Signals.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"

namespace asperity
{
namespace
{
volatile std::sig_atomic_t last_signal = 0;
bool is_watching = false;

// The handler may only do what POSIX calls async-signal-safe.
extern "C" void noteSignal(int number)
{
  if (number == SIGINT && last_signal == SIGINT) {
    std::signal(SIGINT, SIG_DFL);
    std::raise(SIGINT); // delivered when this handler returns
  }
  last_signal = number;
}
} // namespace

StopSignals::StopSignals()
{
  ASPERITY_ASSERT(!is_watching);
  is_watching = true;
  last_signal = 0;
  struct sigaction action = {};
  action.sa_handler = noteSignal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART; // no interrupted system calls in MPI or HDF5
  sigaction(SIGTERM, &action, &previous_terminate_);
  sigaction(SIGINT, &action, &previous_interrupt_);
}

StopSignals::~StopSignals()
{
  sigaction(SIGTERM, &previous_terminate_, nullptr);
  sigaction(SIGINT, &previous_interrupt_, nullptr);
  is_watching = false;
}

int StopSignals::received() const { return last_signal; }

int StopSignals::agreed(Communicator const& communicator) const
{
  return maxOverRanks(received(), communicator);
}
} // namespace asperity

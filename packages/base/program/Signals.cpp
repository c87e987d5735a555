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
  for (std::size_t i = 0; i < watched.size(); ++i) {
    sigaction(watched[i], nullptr, &previous_[i]);
    const bool stays_ignored =
      previous_[i].sa_handler == SIG_IGN && (watched[i] == SIGHUP || watched[i] == SIGPIPE);
    if (!stays_ignored) {
      sigaction(watched[i], &action, nullptr);
    }
  }
}

StopSignals::~StopSignals()
{
  for (std::size_t i = 0; i < watched.size(); ++i) {
    sigaction(watched[i], &previous_[i], nullptr);
  }
  is_watching = false;
}

int StopSignals::received() const { return last_signal; }

StopSignals::Agreed StopSignals::agreed(bool wish, Communicator const& communicator) const
{
  const int all = maxOverRanks(2 * received() + (wish ? 1 : 0), communicator);
  return {all / 2, all % 2 != 0};
}

std::string signalName(int number)
{
  switch (number) {
  case SIGTERM: return "SIGTERM";
  case SIGINT: return "SIGINT";
  case SIGHUP: return "SIGHUP";
  case SIGUSR1: return "SIGUSR1";
  case SIGPIPE: return "SIGPIPE";
  default: return "signal " + std::to_string(number);
  }
}
} // namespace asperity

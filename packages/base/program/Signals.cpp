#include "base/program/Signals.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"

namespace asperity
{
namespace
{
volatile std::sig_atomic_t last_signal = 0;
bool is_watching = false;
bool hangup_was_ignored = false, pipe_was_ignored = false;

bool isIgnored(int number)
{
  struct sigaction action = {};
  sigaction(number, nullptr, &action);
  return action.sa_handler == SIG_IGN;
}

bool staysIgnored(int number)
{
  return (number == SIGHUP && (hangup_was_ignored || isIgnored(number))) ||
         (number == SIGPIPE && (pipe_was_ignored || isIgnored(number)));
}

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
    if (staysIgnored(watched[i])) {
      previous_[i].sa_handler = SIG_IGN;
      previous_[i].sa_flags = 0; // no SA_SIGINFO, which has its handler elsewhere
      sigaction(watched[i], &previous_[i], nullptr);
    } else {
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

void noteIgnoredSignals(int, char**, char**)
{
  hangup_was_ignored = isIgnored(SIGHUP);
  pipe_was_ignored = isIgnored(SIGPIPE);
}

std::string signalName(int number)
{
  switch (number) {
  case SIGTERM: return "SIGTERM";
  case SIGINT: return "SIGINT";
  case SIGHUP: return "SIGHUP";
  case SIGUSR1: return "SIGUSR1";
  case SIGUSR2: return "SIGUSR2";
  case SIGXCPU: return "SIGXCPU";
  case SIGPIPE: return "SIGPIPE";
  default: return "signal " + std::to_string(number);
  }
}
} // namespace asperity

#pragma once

#include "base/Types.hpp"

#include <csignal>

namespace asperity
{
// While it lives, SIGTERM and SIGINT raise a flag instead of ending the process, so that a run can
// leave a last checkpoint. A second SIGINT ends the process at once. Only one object may exist at a
// time; its destructor restores the handlers that were there before.
class StopSignals
{
public:
  StopSignals();
  ~StopSignals();
  StopSignals(StopSignals const&) = delete;
  StopSignals& operator=(StopSignals const&) = delete;

  // The last signal this rank received, 0 if none.
  int received() const;

  // The largest signal number any rank received, the same on all ranks; 0 if none. Collective.
  int agreed(Communicator const& communicator) const;

private:
  struct sigaction previous_terminate_;
  struct sigaction previous_interrupt_;
};
} // namespace asperity

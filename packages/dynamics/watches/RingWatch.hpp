#pragma once

#include "dynamics/watches/Watch.hpp"

namespace asperity::dynamics
{
// Warns of a slip rate that rings: its peak over the fault goes up and down from one step to the
// next, as an oscillation does that the steps are too long for and the scheme, Newmark's, does not
// damp. Then cycles are too short, and the peak passes the threshold of an event several times.
class RingWatch : public Watch
{
public:
  static std::string meaning() { return "a slip rate that rings"; }

  RingWatch() = default;
  RingWatch(Teuchos::ParameterList const&, WatchContext const& context) : fault_(&context.fault) {}

  // time: at the end of a step [s]; rate: the peak slip rate there [m/s]. Returns a warning for the
  // 10th, 100th, ... step in a row that rings.
  std::optional<Warning> note(double time, double rate);
  // Looks at nothing where no state of the fault decides: prescribed slip rates may ring.
  void note(WatchedState const& now, Notes& notes) override;

private:
  Fault const* fault_ = nullptr;
  double rate_ = -1;       // before the step; negative before the first one
  int direction_ = 0;      // 1 up, -1 down, 0 neither
  std::int64_t turns_ = 0; // in a row
  std::int64_t next_warning_ = 10;
};
} // namespace asperity::dynamics

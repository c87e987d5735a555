#pragma once

#include "base/Warning.hpp"
#include "dynamics/State.hpp"
#include "dynamics/fault/Fault.hpp"

#include <optional>

namespace asperity::scenario
{
// Notes where processes on a fault, such as the pressure of a fluid, leave no normal stress to
// friction.
class PressureWatch
{
public:
  // The fault must outlive this.
  explicit PressureWatch(dynamics::Fault const& fault) : fault_(fault) {}

  // Looks at the end of a step, at `time` [s]; a warning the first time that a node which slides
  // has lost its normal stress. The same on all ranks. Collective.
  std::optional<Warning> note(dynamics::State const& now, double time);

private:
  dynamics::Fault const& fault_;
  bool has_warned_ = false;
};
} // namespace asperity::scenario

#pragma once

#include "dynamics/watches/Watch.hpp"
#include "parameters/Parameters.hpp"

#include <string>

namespace asperity::scenario
{
// Notes where processes on a fault that cannot open, such as the pressure of a fluid, leave no
// normal stress to friction.
class PressureWatch : public dynamics::Watch
{
public:
  static std::string meaning() { return "a pressure that reaches the normal stress"; }

  PressureWatch(ParameterList const&, dynamics::WatchContext const& context) : fault_(context.fault)
  {
  }

  // Warns the first time that a node which slides has lost its normal stress.
  void note(dynamics::WatchedState const& now, dynamics::Notes& notes) override;

private:
  dynamics::Fault const& fault_;
  bool has_warned_ = false;
};
} // namespace asperity::scenario

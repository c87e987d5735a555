#pragma once

#include "dynamics/watches/Watch.hpp"

namespace asperity::dynamics
{
// Warns where TNNMG raises J, which it must not.
class EnergyIncreaseWatch : public Watch
{
public:
  static std::string meaning() { return "an energy that grows in an iteration of TNNMG"; }

  EnergyIncreaseWatch() = default;
  EnergyIncreaseWatch(Teuchos::ParameterList const&, WatchContext const&) {}

  void note(WatchedState const& now, Notes& notes) override;
  // count: sweeps and corrections so far in which J grew. A warning for the first one, and again
  // whenever there are ten times as many.
  std::optional<Warning> note(std::int64_t count);

private:
  std::int64_t next_warning_ = 1;
};
} // namespace asperity::dynamics

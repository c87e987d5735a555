#pragma once

#include "dynamics/control/AdaptiveSettings.hpp"
#include "dynamics/control/StepControlKind.hpp"

namespace asperity::dynamics
{
// Pipping 2014, A.3: a step is fine enough if two steps of half its size lead to nearly the same
// alpha. The coarsest such step is accepted, starting from twice the last size; the finer ones
// already computed become the next trials.
class StepDoubling final : public StepControl
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning();
  // A restart may change all: they decide on the steps to come alone.
  static bool mayChange(std::string const&) { return true; }
  static std::string toleranceEntry() { return "Tolerance"; }

  StepDoubling(ControlContext const& context, AdaptiveSettings const& settings);
  StepDoubling(Teuchos::ParameterList const& parameters, ControlContext const& context);
  AcceptedStep advance(State& current, SolveCount& count) override;

private:
  void findTrial(State const& current, SolveCount& count);
  bool coarsen(State const& current, std::optional<Trial>& next, double& error, SolveCount& count);
  bool refine(State const& current, std::optional<Trial>& next, double& error, SolveCount& count);

  AdaptiveSettings settings_;
  WaveError waves_;
};
} // namespace asperity::dynamics

#pragma once

#include "dynamics/control/StepControlKind.hpp"

#include <vector>

namespace asperity::dynamics
{
// Steps of given levels, one after the other; the last one is repeated.
class PrescribedSteps final : public StepControl
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning();
  static std::vector<int> levelsIn(Teuchos::ParameterList const& parameters); // of a complete list

  PrescribedSteps(ControlContext const& context, std::vector<int> levels);
  // Throws InputError where a level is below the smallest step.
  PrescribedSteps(Teuchos::ParameterList const& parameters, ControlContext const& context);
  AcceptedStep advance(State& current, SolveCount& count) override;
  bool adapts() const override { return false; }

private:
  SizeOfLastStep sizeOfLastStep() const override
  {
    return {"as prescribed", "in a new run smaller steps in 'Prescribed / Levels'"};
  }

  std::vector<int> levels_;
};
} // namespace asperity::dynamics

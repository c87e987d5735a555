#include "dynamics/control/PrescribedSteps.hpp"

#include "base/Errors.hpp"
#include "parameters/Parameters.hpp"

#include <algorithm>

namespace asperity::dynamics
{
namespace
{
std::vector<int> levelsOf(Teuchos::ParameterList const& parameters, ControlContext const& context)
{
  auto const levels = parameters.get<Teuchos::Array<int>>("Levels").toVector();
  ASPERITY_REQUIRE(!levels.empty(), context.path << " / Prescribed / Levels is empty.");
  const int finest = context.step.clock().finestLevel();
  for (int level : levels) {
    ASPERITY_REQUIRE(level <= finest, context.path << " / Prescribed / Levels: " << level
                                                   << " is below the smallest step, level "
                                                   << finest << ".");
  }
  return levels;
}
} // namespace

Teuchos::RCP<const Teuchos::ParameterList> PrescribedSteps::validParameters()
{
  return Declare()
    .integerArray("Levels", std::vector<int>{0}, Range::closed(0, 60),
                  "Each step is the largest one divided by two to the power of its entry; the last "
                  "entry is repeated. A step that is cut short to meet an instant uses up its "
                  "entry.")
    .list();
}

std::string PrescribedSteps::meaning() { return "the sizes are listed."; }

PrescribedSteps::PrescribedSteps(Teuchos::ParameterList const& parameters,
                                 ControlContext const& context)
    : PrescribedSteps(context.step, levelsOf(parameters, context))
{
}

PrescribedSteps::PrescribedSteps(CoupledStep& step, std::vector<int> levels)
    : StepControl(step)
    , levels_(std::move(levels))
{
  ASPERITY_ASSERT(!levels_.empty());
}

AcceptedStep PrescribedSteps::advance(State& current, SolveCount& count)
{
  auto const which = std::min<std::size_t>(memory_.num_steps, levels_.size() - 1);
  return makeStep(current, levels_[which], count);
}

ASPERITY_REGISTER(StepControlRegistry, "Prescribed", StepControlKindOf<PrescribedSteps>)
} // namespace asperity::dynamics

#include "dynamics/control/PrescribedSteps.hpp"

#include "base/Errors.hpp"
#include "parameters/Entries.hpp"

#include <algorithm>

namespace asperity::dynamics
{
namespace
{
struct LevelSettings
{
  std::vector<int> levels = {0};
};

Entries<LevelSettings> levelEntries()
{
  return Entries<LevelSettings>().integerArray(
    "Levels", &LevelSettings::levels, Range::closed(0, 60),
    "Each step is the largest one divided by two to the power of its entry; the last "
    "entry is repeated. A step that is cut short to meet an instant uses up its "
    "entry.");
}

std::vector<int> levelsOf(Teuchos::ParameterList const& parameters, ControlContext const& context)
{
  auto const levels = PrescribedSteps::levelsIn(parameters);
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
  return levelEntries().list();
}

std::vector<int> PrescribedSteps::levelsIn(Teuchos::ParameterList const& parameters)
{
  return levelEntries().read(parameters, parameters.name()).levels;
}

std::string PrescribedSteps::meaning() { return "the sizes are listed."; }

PrescribedSteps::PrescribedSteps(Teuchos::ParameterList const& parameters,
                                 ControlContext const& context)
    : PrescribedSteps(context, levelsOf(parameters, context))
{
}

PrescribedSteps::PrescribedSteps(ControlContext const& context, std::vector<int> levels)
    : StepControl(context)
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

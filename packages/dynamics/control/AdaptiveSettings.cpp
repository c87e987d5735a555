#include "dynamics/control/AdaptiveSettings.hpp"

namespace asperity::dynamics
{
namespace
{
// The level of the largest dyadic step that is not above `size`.
int levelOf(DyadicTime const& clock, double size)
{
  int level = 0;
  while (level < clock.finestLevel() && clock.stepSize(level) > size * (1 + 1e-12)) {
    ++level;
  }
  return level;
}
} // namespace

AdaptiveSettings AdaptiveSettings::from(Teuchos::ParameterList const& parameters,
                                        DyadicTime const& clock)
{
  AdaptiveSettings settings;
  settings.tolerance = parameters.get<double>("Tolerance");
  settings.finest_level = clock.finestLevel();
  const double first = parameters.get<double>("First Step");
  settings.first_level = first > 0 ? levelOf(clock, first) : clock.finestLevel();
  if (parameters.isParameter("Norm")) {
    settings.norm = normOf(parameters);
  }
  return settings;
}
} // namespace asperity::dynamics

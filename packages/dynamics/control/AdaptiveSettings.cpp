#include "dynamics/control/AdaptiveSettings.hpp"

namespace asperity::dynamics
{
namespace
{
constexpr char const* weight_of_waves = "Weight of Waves";

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
                                        DyadicTime const& clock, double wave_rate)
{
  AdaptiveSettings settings;
  settings.tolerance = parameters.get<double>("Tolerance");
  settings.finest_level = clock.finestLevel();
  const double first = parameters.get<double>("First Step");
  settings.first_level = first > 0 ? levelOf(clock, first) : clock.finestLevel();
  if (parameters.isParameter("Norm")) {
    settings.norm = normOf(parameters);
  }
  settings.waves = {wave_rate, parameters.get<double>(weight_of_waves)};
  return settings;
}

Declare& declareWaves(Declare& list)
{
  // Chosen: with a tolerance of 1e-5 tests/verification/layer has its onsets to 0.1 %, and with
  // 1e-3 xml/tpv101_2d.xml needs no largest step.
  return list.real(weight_of_waves, 0.1, "-", Range::atLeast(0),
                   "The error of waves in the body counts times this: the largest error of "
                   "velocity, as a share of the slip rate plus b sigma_n / Z with the shear "
                   "impedance Z. 0 leaves it out. Newmark has no estimate of it.");
}
} // namespace asperity::dynamics

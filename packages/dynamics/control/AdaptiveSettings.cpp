#include "dynamics/control/AdaptiveSettings.hpp"

namespace asperity::dynamics
{
namespace
{
// The level of the largest dyadic step that is not above `size`, but for the rounding of a decimal
// number in a deck.
int levelOf(DyadicTime const& clock, double size)
{
  constexpr double rounding = 1e-12;
  int level = 0;
  while (level < clock.finestLevel() && clock.stepSize(level) > size * (1 + rounding)) {
    ++level;
  }
  return level;
}
} // namespace

void AdaptiveSettings::setLevels(DyadicTime const& clock, double wave_rate)
{
  finest_level = clock.finestLevel();
  first_level = first_step > 0 ? levelOf(clock, first_step) : clock.finestLevel();
  waves.slip_rate = wave_rate;
}

Entries<AdaptiveSettings>& addCommonEntries(Entries<AdaptiveSettings>& entries,
                                            std::string const& meaning_of_first_step)
{
  return entries
    .real(
      "Weight of Waves", [](AdaptiveSettings & settings) -> auto& { return settings.waves.weight; },
      "-", Range::atLeast(0),
      "The error of waves in the body counts times this: the largest error of velocity, as a share "
      "of the slip rate plus b sigma_n / Z with the shear impedance Z. 0 leaves it out. Newmark "
      "has no estimate of it.")
    .real("First Step", &AdaptiveSettings::first_step, "s", Range::atLeast(0),
          meaning_of_first_step);
}
} // namespace asperity::dynamics

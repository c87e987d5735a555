#include "dynamics/watches/EnergyIncreaseWatch.hpp"

#include <string>

namespace asperity::dynamics
{
void EnergyIncreaseWatch::note(WatchedState const& now, Notes& notes)
{
  notes.add(note(now.energy_increases));
}

std::optional<Warning> EnergyIncreaseWatch::note(std::int64_t count)
{
  if (count < next_warning_) {
    return std::nullopt;
  }
  next_warning_ = 10 * count;
  return Warning{
    "energy increase",
    "J grew " + (count == 1 ? "once" : std::to_string(count) + " times") +
      " in sweeps or corrections of TNNMG (energy_increases in steps.csv) by more than rounding. J "
      "is the energy that every time step minimises; it must fall. Results of these steps may be "
      "wrong: please report this with the deck."};
}
} // namespace asperity::dynamics

ASPERITY_REGISTER(asperity::dynamics::WatchRegistry, "energy_increase_watch",
                  asperity::dynamics::WatchKindOf<asperity::dynamics::EnergyIncreaseWatch>)

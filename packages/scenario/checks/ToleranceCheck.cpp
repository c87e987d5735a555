#include "scenario/checks/ToleranceCheck.hpp"

#include "base/Text.hpp"

namespace asperity::scenario
{
std::vector<Warning> warnOfTolerances(TimeSettings const& time,
                                      dynamics::CouplingSettings const& coupling)
{
  // Twice what decks in space have. With backward Euler and a tolerance of 0.03 the first event of
  // spring_slider.xml comes after 59 s; the exact time is 345 s.
  constexpr double loose = 0.02;
  std::vector<Warning> warnings;
  if (time.tolerance > loose) {
    warnings.push_back(
      {"loose tolerance",
       "Time Stepping / " + time.control + " / " + time.tolerance_entry + " = " +
         formatShort(time.tolerance) + " is looser than " + formatShort(loose) +
         ": numbers and times of earthquakes may be wrong. Decks have 1e-5 to 1e-2; asperity-study "
         "--convergence shows the effect of a tolerance."});
  }
  if (time.tolerance > 0 && coupling.tolerance > time.tolerance) {
    warnings.push_back(
      {"coupling tolerance",
       "Coupling / Tolerance = " + formatShort(coupling.tolerance) +
         " is above the Tolerance = " + formatShort(time.tolerance) +
         " of the step control: the errors that it leaves add up over many steps, and intervals "
         "between events change. Leave it out: the default is a thousandth."});
  }
  return warnings;
}
} // namespace asperity::scenario

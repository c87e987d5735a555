#include "scenario/checks/StartCheck.hpp"

#include "base/Text.hpp"

#include <cmath>

namespace asperity::scenario
{
namespace
{
// The share of the fault that may slip against the load at the start: a patch may do so on purpose.
constexpr double largest_contradiction = 0.5;
// The share of the forces at the start that may be unbalanced. The tolerance of solvers and rounded
// numbers in a deck leave less; a state of one run under the loads of another, or a traction in
// other units, leaves far more.
constexpr double largest_imbalance = 0.01;
} // namespace

std::vector<Warning> warnOfStart(double imbalance, double contradiction)
{
  std::vector<Warning> warnings;
  if (imbalance > largest_imbalance) {
    warnings.push_back(
      {"start out of balance",
       "The run starts out of balance: " + formatShort(imbalance) +
         " of the forces are not balanced (at most " + formatShort(largest_imbalance) +
         " is usual). A quasi-dynamic body has no inertia, so that velocities and stresses jump in "
         "the first step, however small it is. Check Friction / Shear Traction, whose unit is Pa, "
         "or choose Initial State / State = Stress Balance."});
  }
  if (contradiction > largest_contradiction) {
    warnings.push_back(
      {"friction at the start",
       "At the start friction acts with the load instead of against it over " +
         formatShort(std::round(1000 * contradiction) / 10) +
         " % of the fault, which slips against its shear traction: the traction changes its sign "
         "in the first step, and the jump sets off waves. Check the signs of Friction / Shear "
         "Traction and of the velocity or slip rate under Initial State."});
  }
  return warnings;
}
} // namespace asperity::scenario

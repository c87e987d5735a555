#pragma once

#include "dynamics/Body.hpp"
#include "scenario/problem/SetupContext.hpp"

#include <vector>

namespace asperity::scenario
{
// The displacement at the start, and the normal stress on the fault in the static solution.
struct StaticStart
{
  RCP<Vector> displacement;
  // (num fault nodes) [Pa], positive in compression; zero if the deck gives it, or friction does
  // not ask for it
  std::vector<double> normal_stress;
};

// The static solution under the load at t = 0, where the deck asks for it or the normal stress
// follows from it; zero elsewhere. Throws InputError where it is needed and does not exist, see
// StartRequirements.hpp. Collective.
template <int Dim>
StaticStart staticStart(SetupContext<Dim> const& context, dynamics::Body const& body,
                        Vector const& load);
} // namespace asperity::scenario

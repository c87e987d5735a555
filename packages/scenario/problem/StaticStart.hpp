#pragma once

#include "dynamics/Body.hpp"
#include "scenario/problem/SetupContext.hpp"

#include <vector>

namespace asperity::scenario
{
// The displacement at the start, and the pressure of the foundation in it.
struct StaticStart
{
  RCP<Vector> displacement;
  // (num fault nodes) [Pa]; zero if the deck gives it, or friction does not ask for it
  std::vector<double> pressure;
};

// The static solution under the load at t = 0, where the deck asks for it or the normal stress
// follows from it; zero elsewhere. Throws InputError where it is needed and does not exist, see
// StartRequirements.hpp. Collective.
template <int Dim>
StaticStart staticStart(SetupContext<Dim> const& context, dynamics::Body const& body,
                        Vector const& load);
} // namespace asperity::scenario

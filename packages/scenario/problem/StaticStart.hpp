#pragma once

#include "dynamics/Body.hpp"
#include "dynamics/coupling/RateSolver.hpp"
#include "fem/FaultSurface.hpp"
#include "scenario/problem/Discretisation.hpp"
#include "scenario/problem/SetupContext.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// Without inertia every rigid motion of the body needs something that stops or resists it: a
// condition, or friction and radiation damping along the fault that is given, unless it is null.
// `why` says what does not exist otherwise, `cure` what else helps.
template <int Dim>
void requireNoFreeMotion(Discretisation<Dim> const& discretisation, dynamics::Body const& body,
                         fem::FaultSurface const* resisting_fault, std::string const& why,
                         std::string const& cure = "");

// The displacement at the start, and the pressure of the foundation in it.
struct StaticStart
{
  RCP<Vector> displacement;
  // (num fault nodes) [Pa]; zero if the deck gives it, or friction does not ask for it
  std::vector<double> pressure;
};

// The static solution under the load at t = 0, where the deck asks for it or the normal stress
// follows from it. Throws InputError where there is none. Collective.
template <int Dim>
StaticStart staticStart(SetupContext<Dim> const& context, dynamics::Body const& body,
                        Vector const& load);

// Throws InputError if rock yields under its stress at the start. Collective.
template <int Dim>
void requireNoInitialYield(Discretisation<Dim> const& discretisation, dynamics::Body const& body,
                           Vector const& u);
} // namespace asperity::scenario

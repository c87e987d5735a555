#pragma once

#include "dynamics/Body.hpp"
#include "fem/FaultSurface.hpp"
#include "scenario/problem/Discretisation.hpp"
#include "scenario/problem/SetupContext.hpp"

// What a problem and its state at the start have to meet. Each function throws InputError on all
// ranks where its requirement is not met. Collective.
namespace asperity::scenario
{
// The deck gives the normal stress on the fault (stress_given), or it can follow from the static
// solution under a load; and it can change as `Normal Stress Change` says.
template <int Dim>
void requireNormalStress(SetupContext<Dim> const& context, bool stress_given, bool has_load);

// The static solution exists and is unique: something other than the fault, on which the body
// slides without friction, stops every rigid motion of the body.
// stress_given: the normal stress does not need the solution, so that the deck can do without it.
template <int Dim>
void requireStaticSolution(Discretisation<Dim> const& discretisation, dynamics::Body const& body,
                           bool stress_given);

// The velocity of a body without mass exists and is unique: a condition stops every rigid motion of
// the body, or friction and radiation damping on the fault resist it.
template <int Dim>
void requireMasslessVelocity(Discretisation<Dim> const& discretisation, dynamics::Body const& body,
                             fem::FaultSurface const& fault);

// No rock yields under its stress at the displacement u of the start.
template <int Dim>
void requireNoInitialYield(Discretisation<Dim> const& discretisation, dynamics::Body const& body,
                           Vector const& u);
} // namespace asperity::scenario

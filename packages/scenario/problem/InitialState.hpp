#pragma once

#include "base/Warning.hpp"
#include "dynamics/Body.hpp"
#include "dynamics/State.hpp"
#include "dynamics/fault/Fault.hpp"
#include "scenario/problem/SetupContext.hpp"

#include <optional>

namespace asperity::scenario
{
// Data that determine the initial state, in addition to the body and the fault.
struct StartOfRun
{
  RCP<Vector> displacement;
  std::vector<double> traction;       // (num_nodes, T) that drives the body along the tangents [Pa]
  std::vector<double> slip_direction; // (num_nodes, T) unit vectors, ShearTraction::direction
};

// The state at t = 0 by the deck's list `Initial State`.
//
// The velocity is the prescribed one at held dofs, elsewhere that of the list, which may give the
// slip rate of the fault separately. alpha follows from the list's `State`
// (dynamics::initialAlpha); an InputError names the place where there is no such state. The given
// traction is the only one that drives the fault: a static displacement leaves no shear traction,
// since it is computed without friction, and a displacement of zero leaves none either. Collective.
template <int Dim>
dynamics::State makeInitialState(SetupContext<Dim> const& context, dynamics::Body const& body,
                                 dynamics::Fault const& fault, StartOfRun const& start);

// A warning where the deck gives an initial velocity without a slip rate on a two-sided fault in a
// quasi-dynamic model: both sides then move together, so that the fault does not slip, and the
// velocity has no other effect. Collective.
template <int Dim>
std::optional<Warning> warnOfVelocity(SetupContext<Dim> const& context);
} // namespace asperity::scenario

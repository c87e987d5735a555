#pragma once

#include "base/Warning.hpp"
#include "dynamics/Body.hpp"
#include "dynamics/State.hpp"
#include "dynamics/fault/Fault.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/problem/SetupContext.hpp"

#include <optional>

namespace asperity::scenario
{
// The deck's list `Initial State`.
RCP<const ParameterList> initialStateParameters();

// Whether the body starts from the static displacement under gravity.
bool startsStatic(ParameterList const& list);

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
// since the fault has slid without friction, and neither does zero displacement.
template <int Dim>
dynamics::State makeInitialState(SetupContext<Dim> const& context, dynamics::Body const& body,
                                 dynamics::Fault const& fault, StartOfRun const& start);

// Warns of an initial velocity that moves both sides of a two-sided fault, and so does not make it
// slip, in a quasi-dynamic model, where it has no other effect. Collective.
template <int Dim>
std::optional<Warning> warnOfVelocity(BulkSettings const& bulk, ParameterList const& deck,
                                      Mesh<Dim> const& mesh, fem::FaultSurface const& surface);
} // namespace asperity::scenario

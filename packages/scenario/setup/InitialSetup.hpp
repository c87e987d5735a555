#pragma once

#include "base/parameters/Parameters.hpp"
#include "dynamics/Body.hpp"
#include "dynamics/Fault.hpp"
#include "dynamics/State.hpp"
#include "dynamics/coupling/RateSolver.hpp"
#include "fem/constraints/Constraints.hpp"

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
  std::vector<double> radiation;      // (num_nodes) damping eta [Pa s/m]
};

// The state at t = 0 by the deck's list `Initial State`.
//
// The velocity is the prescribed one at held dofs, elsewhere that of the list, which may give the
// slip rate of the fault separately. alpha at the fault nodes depends on the list's `State`:
//   Given           the field `alpha`;
//   Steady          d(alpha)/dt = 0 at the slip rate V;
//   Stress Balance  sigma_n mu(V, alpha) + cohesion + eta V = traction (along the velocity).
// Where the velocity is prescribed and the slip rate is zero, friction is never evaluated and alpha
// is the field `alpha`. Throws InputError with the place if there is no such state at a node. The
// given traction is the only one that drives the fault: a static displacement leaves no shear
// traction, since the fault has slid without friction, and neither does zero displacement.
template <int Dim>
dynamics::State makeInitialState(ParameterList const& deck, Mesh<Dim> const& mesh,
                                 fem::Constraints<Dim> const& constraints,
                                 dynamics::Body const& body, dynamics::Fault const& fault,
                                 dynamics::RateSolverSettings const& solver,
                                 StartOfRun const& start);
} // namespace asperity::scenario

#pragma once

#include "base/parameters/Parameters.hpp"
#include "dynamics/Body.hpp"
#include "dynamics/Fault.hpp"
#include "fem/Constraints.hpp"

namespace asperity::scenario
{
// The deck's list `Initial State`.
RCP<const ParameterList> initialStateParameters();

// The velocity at t = 0: prescribed where it is fixed, elsewhere that of the list.
template <int Dim>
RCP<Vector> initialVelocity(ParameterList const& list, Mesh<Dim> const& mesh,
                            dynamics::Body const& body, fem::Constraints<Dim> const& constraints);

// What the state of the fault follows from.
struct InitialFault
{
  std::vector<double> traction;  // (num_nodes, T) that drives the body along the tangents [Pa]
  std::vector<double> velocity;  // (num_nodes, T) of the body along the tangents [m/s]
  std::vector<double> radiation; // (num_nodes) damping eta [Pa s/m]
};

// alpha at the fault nodes by the list's `State`:
//   Given           the field `alpha`;
//   Steady          d(alpha)/dt = 0 at the slip rate V;
//   Stress Balance  sigma_n mu(V, alpha) + cohesion + eta V = traction (along the velocity).
// Where the velocity is prescribed and zero, friction is never asked for: `alpha`. InputError with
// the place where there is no such state.
template <int Dim>
friction::NodeView initialAlpha(ParameterList const& list, Mesh<Dim> const& mesh,
                                std::vector<int> const& nodes, dynamics::Fault const& fault,
                                InitialFault const& at_start);
} // namespace asperity::scenario

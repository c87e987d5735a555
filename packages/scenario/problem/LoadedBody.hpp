#pragma once

#include "dynamics/Body.hpp"
#include "scenario/problem/SetupContext.hpp"
#include "scenario/setup/friction/FaultLoads.hpp"

namespace asperity::scenario
{
// The body of a problem and what loads it.
struct LoadedBody
{
  dynamics::Body body;
  ShearTraction traction; // on the fault
  // At t = 0, without the shear traction on the fault and the radiation of moving plates: what the
  // static solution bears [N].
  RCP<const Vector> static_load;
};

// matrices: of the body alone. They get dashpots and springs of boundaries and the radiation
// damping of the fault, and lose the mass of a quasi-dynamic body. InputError where the body's
// velocity does not exist. Collective.
template <int Dim>
LoadedBody makeBody(SetupContext<Dim> const& context, fem::BodyMatrices matrices);
} // namespace asperity::scenario

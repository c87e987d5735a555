#pragma once

#include "dynamics/fault/Fault.hpp"
#include "scenario/problem/SetupContext.hpp"

namespace asperity::scenario
{
// What a fault needs that may open (Contact = Unilateral); does nothing for other faults. Throws
// InputError on all ranks where the deck asks for what its equations do not have: the normal stress
// is that of contact, Coupled and without a floor; nothing but friction by this stress bears shear;
// pressures are known when a step begins; and the scheme has a rule for impacts, if there is
// inertia. Collective.
template <int Dim>
void requireOpening(SetupContext<Dim> const& context, dynamics::Fault const& fault);

// Throws InputError on all ranks where a fault that may open meets another one, with the place.
// Collective.
template <int Dim>
void requireNoJunction(BoundaryConditions<Dim> const& boundary, Mesh<Dim> const& mesh,
                       Communicator const& communicator);
} // namespace asperity::scenario

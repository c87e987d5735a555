#pragma once

#include "dynamics/Fault.hpp"
#include "mesh/Mesh.hpp"
#include "scenario/setup/NodalField.hpp"

namespace asperity::scenario
{
// The deck's list `Friction`: laws with their parameters, and what friction needs besides.
RCP<const ParameterList> frictionParameters();

// What acts on the fault: the laws of the list with their parameters at its nodes.
template <int Dim>
dynamics::Fault makeFault(ParameterList const& list, Mesh<Dim> const& mesh,
                          std::shared_ptr<const fem::FaultSurface> const& surface,
                          dynamics::NormalStress const& normal_stress);
} // namespace asperity::scenario

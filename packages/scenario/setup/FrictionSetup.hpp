#pragma once

#include "dynamics/Fault.hpp"
#include "fem/BoundaryNodes.hpp"
#include "fem/Constraints.hpp"
#include "mesh/Mesh.hpp"
#include "scenario/setup/NodalField.hpp"

namespace asperity::scenario
{
// The deck's list `Friction`: laws with their parameters, and what friction needs besides.
RCP<const ParameterList> frictionParameters();

// Everything but the normal stress, which is zero until setNormalStress (FaultLoads.hpp).
template <int Dim>
dynamics::Fault makeFault(ParameterList const& list, Mesh<Dim> const& mesh,
                          fem::BoundaryNodes<Dim> const& boundary, fem::DofMap const& dofs,
                          fem::Constraints<Dim> const& constraints, double slip_factor);

// One value for each fault node.
friction::NodeView toDevice(std::vector<double> const& values, std::string const& label);
} // namespace asperity::scenario

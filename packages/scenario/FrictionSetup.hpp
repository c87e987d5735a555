#pragma once

#include "dynamics/Fault.hpp"
#include "fem/BoundaryNodes.hpp"
#include "fem/Constraints.hpp"
#include "mesh/Mesh.hpp"
#include "scenario/NodalField.hpp"

namespace asperity::scenario
{
// The deck's list `Friction` for the chosen laws: the tables of both, and what friction needs
// besides.
RCP<const ParameterList> frictionParameters(std::string const& law, std::string const& state_law);

// A field of a list at the fault nodes.
friction::NodeView valuesAtNodes(ParameterList const& list, std::string const& name,
                                 std::string const& where, Mesh<2> const& mesh,
                                 std::vector<int> const& nodes);

// Everything but the normal stress, which is zero until setNormalStress.
dynamics::Fault makeFault(ParameterList const& list, Mesh<2> const& mesh,
                          fem::BoundaryNodes<2> const& boundary, fem::DofMap const& dofs,
                          fem::Constraints<2> const& constraints);

// Normal stress at the fault nodes [Pa], compression positive; a tensile value becomes zero.
struct NormalStress
{
  std::vector<double> values;
  int num_tensile = 0; // over all ranks
};

// Sets |sigma_n| = factor * max(values, 0) and makes the friction kernels.
void setNormalStress(dynamics::Fault& fault, ParameterList const& list, Mesh<2> const& mesh,
                     std::vector<int> const& nodes, NormalStress& stress);
} // namespace asperity::scenario

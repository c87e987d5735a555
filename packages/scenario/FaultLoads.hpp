#pragma once

#include "base/Parameters.hpp"
#include "dynamics/Body.hpp"
#include "dynamics/Fault.hpp"
#include "fem/BoundaryNodes.hpp"
#include "scenario/NodalField.hpp"

namespace asperity::scenario
{
// The deck's `Shear Traction` at the fault nodes [Pa], along the tangents.
NodalField shearTraction(ParameterList const& friction, Mesh<2> const& mesh,
                         std::vector<int> const& nodes);

// Adds the deck's `Shear Traction` on the fault to a constant load: the load of the body at any
// time, evaluated once only where the traction does not depend on t.
std::function<void(double, Vector&)> loadWithTraction(ParameterList const& friction,
                                                      Mesh<2> const& mesh,
                                                      fem::BoundaryNodes<2> const& nodes,
                                                      dynamics::Fault const& fault,
                                                      RCP<const Vector> const& constant);

// Normal stress at the fault nodes [Pa], compression positive; a tensile value becomes zero.
struct NormalStress
{
  std::vector<double> values; // at the start
  int num_tensile = 0;        // over all ranks
};

// |sigma_n| = factor * max(values, 0), of the deck where it gives `Normal Stress`; makes the
// friction kernels. InputError if the deck's normal stress is negative at t = 0; if it depends on t
// the fault follows it, and what becomes negative later counts as zero.
void setNormalStress(dynamics::Fault& fault, ParameterList const& friction, Mesh<2> const& mesh,
                     std::vector<int> const& nodes, NormalStress& stress);
} // namespace asperity::scenario

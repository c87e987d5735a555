#pragma once

#include "base/parameters/Parameters.hpp"
#include "dynamics/Body.hpp"
#include "dynamics/Fault.hpp"
#include "fem/BoundaryNodes.hpp"
#include "fem/NodalFrames.hpp"
#include "scenario/setup/NodalField.hpp"

namespace asperity::scenario
{
// The deck's `Shear Traction` at the fault nodes.
class ShearTraction
{
public:
  template <int Dim>
  ShearTraction(ParameterList const& friction, Mesh<Dim> const& mesh,
                fem::BoundaryNodes<Dim> const& nodes, fem::NodalFrames const& frames);

  bool dependsOnTime() const { return size_.dependsOnTime(); }
  // (num_nodes, T) along the fault's tangents at the time t [s], in Pa.
  std::vector<double> at(double t) const;

private:
  NodalField size_;
  // (num_nodes, T) a unit vector: along the tangent, in three dimensions along the projection of
  // the deck's `Slip Direction`. InputError where that is the fault's normal.
  std::vector<double> direction_;
};

// Adds the deck's `Shear Traction` on the fault to a constant load: the load of the body at any
// time, evaluated once only where the traction does not depend on t.
// weights(num_nodes).
std::function<void(double, Vector&)> loadWithTraction(ShearTraction const& traction,
                                                      std::vector<double> const& weights,
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
template <int Dim>
void setNormalStress(dynamics::Fault& fault, ParameterList const& friction, Mesh<Dim> const& mesh,
                     std::vector<int> const& nodes, NormalStress& stress);
} // namespace asperity::scenario

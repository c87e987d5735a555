#pragma once

#include "base/parameters/Parameters.hpp"
#include "dynamics/NormalStress.hpp"
#include "fem/FaultSurface.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "scenario/setup/NodalField.hpp"

namespace asperity::scenario
{
// The deck's `Shear Traction` at the fault nodes.
class ShearTraction
{
public:
  template <int Dim>
  ShearTraction(ParameterList const& friction, Mesh<Dim> const& mesh,
                fem::FaultSurface const& surface, fem::NodalFrames const& frames);

  bool dependsOnTime() const { return size_.dependsOnTime(); }
  // (num_nodes, T) along the fault's tangents at the time t [s], in Pa.
  std::vector<double> at(double t) const;
  // (num_nodes, T) where it points: a unit vector along the tangents.
  std::vector<double> const& direction() const { return direction_; }

private:
  NodalField size_;
  // (num_nodes, T) a unit vector: along the tangent, in three dimensions along the projection of
  // the deck's `Slip Direction`. InputError where that is the fault's normal.
  std::vector<double> direction_;
};

// Adds the deck's `Shear Traction` on the fault to a constant load: the load of the body at any
// time, evaluated once only where the traction does not depend on t.
std::function<void(double, Vector&)>
loadWithTraction(ShearTraction const& traction,
                 std::shared_ptr<const fem::FaultSurface> const& surface,
                 RCP<const Vector> const& constant);

struct NormalStressOfDeck
{
  dynamics::NormalStress normal_stress;
  std::vector<std::string> remarks; // for the log
};

// |sigma_n| = factor * max(values, 0), of the deck where it gives `Normal Stress`, else the
// pressure(num_nodes) [Pa] of the foundation. InputError if the deck's normal stress is negative at
// t = 0; if it depends on t, what becomes negative later counts as zero. Collective.
template <int Dim>
NormalStressOfDeck makeNormalStress(ParameterList const& friction, Mesh<Dim> const& mesh,
                                    fem::FaultSurface const& surface,
                                    std::vector<double> const& pressure);
} // namespace asperity::scenario

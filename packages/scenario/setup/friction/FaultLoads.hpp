#pragma once

#include "fem/BoundaryLoad.hpp"
#include "fem/FaultSurface.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/setup/NodalField.hpp"
#include "scenario/setup/friction/FrictionSetup.hpp"

namespace asperity::scenario
{
// The deck's `Shear Traction` at the fault nodes.
class ShearTraction
{
public:
  // friction: the deck's list, whose settings are `settings`. nodes: those of the surface.
  ShearTraction(FrictionSettings const& settings, ParameterList const& friction,
                FieldNodes const& nodes, fem::FaultSurface const& surface,
                fem::NodalFrames const& frames);

  bool dependsOnTime() const { return size_.dependsOnTime(); }
  // The traction [Pa] at the time t [s] in components along the fault's tangents, (num_nodes, T).
  std::vector<double> at(double t) const;
  // (num_nodes) the largest size at these times [Pa].
  std::vector<double> largest(std::vector<double> const& times) const;
  // The direction of positive traction: unit vectors in the same components, (num_nodes, T).
  std::vector<double> const& direction() const { return direction_; }

private:
  NodalField size_;
  // The tangent; in three dimensions the projection of the deck's `Slip Direction` onto the fault,
  // or zero where neither a traction nor friction needs it.
  // InputError where that direction is normal to the fault.
  std::vector<double> direction_;
};

// Returns the load of the body as a function of time: a constant load, the deck's `Shear Traction`
// on the fault and the tractions on boundaries. What does not depend on t is evaluated only once.
std::function<void(double, Vector&)> loadWithTraction(
  ShearTraction const& traction, std::shared_ptr<const fem::FaultSurface> const& surface,
  std::shared_ptr<const fem::BoundaryLoad> const& boundaries, RCP<const Vector> const& constant);
} // namespace asperity::scenario

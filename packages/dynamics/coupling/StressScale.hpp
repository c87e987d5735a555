#pragma once

#include "fem/FaultSurface.hpp"
#include "portability/Views.hpp"

namespace asperity::dynamics
{
// What makes a change of a normal stress count like the same change of alpha (StepUnknown::scale).
// A relative change eps of it changes the strength f sigma_n of the fault as much as a change
// f / b eps of alpha, and f / b is about 50. So the scale is 50 / stress [1/Pa]; a stress below
// `least` > 0 counts as that.
KOKKOS_INLINE_FUNCTION double scaleOfStress(double stress, double least)
{
  constexpr double friction_over_b = 50;
  return friction_over_b / (stress > least ? stress : least);
}

// The same at the nodes, where the least is 1 % of the largest. stress(num_nodes) >= 0 [Pa].
// Collective.
void setScaleOfStress(ConstNodeView const& stress, fem::FaultSurface const& surface,
                      NodeView const& scale);
} // namespace asperity::dynamics

#pragma once

#include "fem/constraints/HeldDofs.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "fem/constraints/detail/PrescribedVelocities.hpp"

#include <vector>

namespace asperity::fem::detail
{
// What the conditions of all boundaries make of the nodes, complete: see Constraints.
template <int Dim>
struct ConstrainedNodes
{
  NodalFrames frames;                   // of owned nodes and ghosts
  HeldDofs held;                        // of owned nodes and ghosts
  PrescribedVelocities<Dim> velocities; // of owned dofs
};

// Throws what Constraints throws. Collective.
template <int Dim>
ConstrainedNodes<Dim> constrainNodes(Mesh<Dim> const& mesh, DofMap const& dofs,
                                     std::vector<VelocityCondition<Dim>> conditions,
                                     std::vector<double> const& sample_times);
} // namespace asperity::fem::detail

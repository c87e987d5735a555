#pragma once

#include "base/Types.hpp"
#include "fem/constraints/HeldDofs.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "fem/constraints/VelocityCondition.hpp"
#include "fem/constraints/detail/ConstrainedNodes.hpp"
#include "fem/dofs/DofMap.hpp"

#include <utility>
#include <vector>

namespace asperity::fem
{
// The conditions of all boundaries, turned into nodal frames and fixed dofs.
//
// At a node the directions of its conditions are orthonormalised in the order given, except that
// those of FreeAcrossFault come first. These directions are the last rows of the frame, the
// remaining (tangential) ones its first rows. Where a fault (Normal::of_fault) ends at walls that
// are nearly perpendicular to it, its normal is projected onto their planes. In two dimensions all
// tangents of a fault with its continuations have one sense: their mean points to +x or, where it
// is steeper than 66 degrees, to +y. Where the frame would be that of the axes, but for the order
// of its rows, it is the identity. Conditions with linearly dependent directions must agree to
// 1e-10 of the largest velocity that they prescribe anywhere; otherwise an InputError names two of
// them.
//
// At a pair of vertices of a fault inside the body, conditions hold for mean and jump
// (VertexTerms): conditions on the fault for the jump, those on other boundaries in pairs, one on
// each side. Where two faults cross, the conditions of each hold for its own jump. Where a branch
// ends at a joint, its jump lies in both faults, and a slip that is prescribed there is its part
// along the line.
template <int Dim>
class Constraints
{
public:
  // sample_times: the times at which conditions that share a direction are compared [s].
  // Collective.
  Constraints(Mesh<Dim> const& mesh, DofMap const& dofs,
              std::vector<VelocityCondition<Dim>> conditions,
              std::vector<double> const& sample_times)
      : nodes_(detail::constrainNodes(mesh, dofs, std::move(conditions), sample_times))
  {
  }

  NodalFrames const& frames() const { return nodes_.frames; }
  // Owned and ghost dofs whose velocity is prescribed.
  HeldDofs const& held() const { return nodes_.held; }
  // Sets v(owned dofs) to the prescribed velocity at time t [s] in nodal frames, and to zero at
  // dofs that are not held.
  void prescribedVelocity(double t, Vector& v) const { nodes_.velocities.at(t, v); }
  // The owned dofs whose prescribed velocity may depend on time.
  std::vector<int> dofsThatVary() const { return nodes_.velocities.dofsThatVary(); }

private:
  detail::ConstrainedNodes<Dim> nodes_;
};
} // namespace asperity::fem

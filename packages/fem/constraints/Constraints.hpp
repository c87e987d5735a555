#pragma once

#include "base/Types.hpp"
#include "fem/constraints/HeldDofs.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "fem/constraints/VelocityCondition.hpp"
#include "fem/constraints/detail/ConditionDirections.hpp"
#include "fem/constraints/detail/NodalBasis.hpp"
#include "fem/dofs/DofMap.hpp"

#include <optional>
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
// each side. Where two faults cross, the conditions of each hold for its own jump.
template <int Dim>
class Constraints
{
public:
  // sample_times: the times at which conditions that share a direction are compared [s].
  Constraints(Mesh<Dim> const& mesh, DofMap const& dofs,
              std::vector<VelocityCondition<Dim>> conditions,
              std::vector<double> const& sample_times);

  NodalFrames const& frames() const { return frames_; }
  // Owned and ghost dofs whose velocity is prescribed.
  HeldDofs const& held() const { return *held_; }
  // Sets v(owned dofs) to the prescribed velocity at time t [s] in nodal frames, and to zero at
  // dofs that are not held.
  void prescribedVelocity(double t, Vector& v) const;
  // The owned dofs whose prescribed velocity may depend on time.
  std::vector<int> dofsThatVary() const;

private:
  using Direction = detail::Direction;
  using NodalDirections = detail::NodalDirections;
  // The velocity of the row is the sum of the coefficients times the velocities of the conditions.
  struct FixedRow
  {
    int dof;
    int node;
    detail::Terms terms;
  };
  std::vector<double> largestVelocities(NodalDirections const& directions,
                                        Communicator const& communicator) const;
  void holdNodes(DofMap const& dofs); // of VertexTerms
  void constrain(DofMap const& dofs, int node, std::vector<Direction> const& directions);
  int turnAt(std::vector<Direction> const& directions) const;
  detail::NodalBasis makeFrame(int node, std::vector<Direction> const& directions,
                               detail::NodalBasis const& prescribed) const;
  int obliqueCondition(std::vector<Direction> const& directions,
                       std::vector<std::vector<double>> const& to) const;
  void requireAgreement(int node, int condition, detail::Terms const& terms) const;
  bool dependsOnTime(FixedRow const& row) const;
  double velocity(FixedRow const& row, double t) const;
  void moveToDevice();
  void shareWithGhosts(DofMap const& dofs);

  std::vector<VelocityCondition<Dim>> conditions_;
  std::vector<double> sample_times_;
  NodalFrames frames_;
  std::vector<int> held_flags_; // while the conditions are collected
  std::optional<HeldDofs> held_;
  std::vector<FixedRow> rows_; // whose velocity depends on time; all while they are collected
  IndexView dofs_of_rows_, constant_dofs_;
  ConstNodeView constant_velocities_; // at constant_dofs_
  std::vector<Point<Dim>> owned_vertices_;
  std::vector<double> largest_; // largest velocity of each condition at the sample times
};
} // namespace asperity::fem

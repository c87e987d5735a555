#pragma once

#include "base/Types.hpp"
#include "fem/DofMap.hpp"
#include "fem/NodalFrames.hpp"
#include "fem/detail/NodalBasis.hpp"
#include "mesh/Mesh.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace asperity::fem
{
// The velocity of a boundary in one direction is prescribed: v . d = velocity(x, t).
template <int Dim>
struct VelocityCondition
{
  std::string name; // for messages, e.g. "Boundary Conditions / Backstop"
  std::string boundary;
  // The components of d along the axes; empty: the inward normal of the boundary at each node, or
  // the tangent that goes with it.
  std::vector<double> direction;
  // m/s; empty: zero (a wall that the body slides along, or bilateral contact).
  std::function<double(Point<Dim> const&, double)> velocity;
  // Without a direction, two components: along the boundary, to the side that NodalFrames has.
  bool tangential = false;
  // Frames follow this direction, but the velocity along it remains free.
  bool free = false;
  // Boundaries that continue this one: their facets count for the normals where they meet it.
  std::vector<std::string> continued_by = {};
};

// Conditions of all boundaries, turned into nodal frames and fixed dofs.
//
// At a node the directions of its conditions are orthonormalised in the order given, those that
// are free before all others; the frame's last rows are these directions, its first rows the
// remaining (tangential) ones. Where the directions are axes the frame is the identity. More
// conditions than directions must agree with one another, to 1e-10 of the largest velocity that
// they prescribe anywhere, or an InputError names both.
template <int Dim>
class Constraints
{
public:
  // sample_times: when conditions that share a direction are compared [s].
  Constraints(Mesh<Dim> const& mesh, DofMap const& dofs,
              std::vector<VelocityCondition<Dim>> conditions,
              std::vector<double> const& sample_times);

  NodalFrames const& frames() const { return frames_; }
  // (num local dofs) nonzero where the velocity is prescribed, for owned and ghost dofs.
  std::vector<char> const& fixed() const { return fixed_; }
  // v(owned dofs): the prescribed velocity at time t [s] in nodal frames, zero at free dofs.
  void prescribedVelocity(double t, Vector& v) const;

private:
  struct Direction
  {
    std::vector<double> vector;
    int condition;
  };
  // velocity of row = sum of coefficients times the conditions' velocities
  struct FixedRow
  {
    int dof;
    int node;
    detail::Terms terms;
  };
  using NodalDirections = std::map<int, std::vector<Direction>>;

  NodalDirections collect(Mesh<Dim> const& mesh) const;
  std::vector<double> largestVelocities(NodalDirections const& directions,
                                        Communicator const& communicator) const;
  void constrain(DofMap const& dofs, int node, std::vector<Direction> const& directions);
  detail::NodalBasis layFrame(int node, std::vector<Direction> const& directions,
                              detail::NodalBasis const& prescribed) const;
  int obliqueCondition(std::vector<Direction> const& directions,
                       std::vector<std::vector<double>> const& to) const;
  void requireAgreement(int node, int condition, detail::Terms const& terms) const;
  double velocity(int condition, Point<Dim> const& x, double t) const;
  void shareWithGhosts(DofMap const& dofs);

  std::vector<VelocityCondition<Dim>> conditions_;
  std::vector<double> sample_times_;
  NodalFrames frames_;
  std::vector<char> fixed_;
  std::vector<FixedRow> rows_;
  std::vector<Point<Dim>> owned_vertices_;
  std::vector<double> largest_; // velocity that each condition prescribes at the sample times
};
} // namespace asperity::fem

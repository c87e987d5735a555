#pragma once

#include "mesh/Mesh.hpp"

#include <functional>
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
  // Without a direction: along the boundary instead. With two components to the side that
  // NodalFrames has; with three along the projection of `towards`, or at right angles to that.
  bool tangential = false;
  std::vector<double> towards = {};
  bool at_right_angles = false;
  // Not empty: at the nodes alone that lie on this boundary, too.
  std::string meeting = {};
  // Frames follow this direction, but the velocity along it remains free.
  bool free = false;
  // Boundaries that continue this one: their facets count for the normals where they meet it.
  std::vector<std::string> continued_by = {};
};
} // namespace asperity::fem

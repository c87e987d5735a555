#pragma once

#include "fem/constraints/VelocityCondition.hpp"
#include "fem/constraints/detail/NodalBasis.hpp"

#include <map>
#include <vector>

namespace asperity::fem::detail
{
// A unit vector along which the velocity is prescribed (or free), the number of the condition that
// says so, and the velocity: that of the condition, except at split vertices.
struct Direction
{
  std::vector<double> vector;
  int condition;
  Terms terms;
};

// The directions at each owned node, by its local number, in the order of the conditions.
using NodalDirections = std::map<int, std::vector<Direction>>;

// Throws InputError where a condition names no boundary of the mesh, or has no direction.
template <int Dim>
NodalDirections collectDirections(Mesh<Dim> const& mesh,
                                  std::vector<VelocityCondition<Dim>> const& conditions,
                                  int components);
} // namespace asperity::fem::detail

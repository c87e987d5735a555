#pragma once

#include "mesh/MeshQuality.hpp"
#include "scenario/setup/NodalField.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// A field of a condition at vertices of its boundary. At most a thousand on each rank are taken,
// which is enough for checks of its size.
template <int Dim>
NodalField boundaryField(BoundaryCondition const& condition, std::string const& entry,
                         Mesh<Dim> const& mesh)
{
  constexpr std::size_t most_vertices = 1000;
  auto const vertices = mesh::boundaryVertices(mesh, condition.boundary);
  const std::size_t stride = vertices.size() / most_vertices + 1;
  std::vector<int> some;
  for (std::size_t i = 0; i < vertices.size(); i += stride) {
    some.push_back(vertices[i]);
  }
  const FieldNodes nodes(mesh, some);
  return {condition.list, entry, condition.name, nodes};
}
} // namespace asperity::scenario

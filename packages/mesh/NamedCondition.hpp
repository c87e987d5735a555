#pragma once

#include "mesh/Mesh.hpp"

#include <functional>

namespace asperity::mesh
{
// The name of a region or a boundary, new or already in the mesh, and the condition that holds
// there.
template <int Dim>
struct NamedCondition
{
  std::string name;
  std::function<bool(Point<Dim> const&)> holds;
};
} // namespace asperity::mesh

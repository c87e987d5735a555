#pragma once

#include "mesh/Mesh.hpp"

#include <functional>

namespace asperity::mesh
{
// Where a region or a piece of the boundary is to be; of a new name, or of one that is there.
template <int Dim>
struct NamedCondition
{
  std::string name;
  std::function<bool(Point<Dim> const&)> holds;
};
} // namespace asperity::mesh

#pragma once

#include "base/Views.hpp"

#include <vector>

namespace asperity::tnnmg
{
// Views of the nodes that carry a nonlinearity on this rank: which rows of Z they have, which rows
// are held, and in which groups a sweep visits them. A node may be held in some components and free
// in others. Then its velocity is zero in the held components, their rows of Z are diagonal, and
// the nonlinearity is isotropic, so that a force along the free components moves the node along
// these.
struct NonlinearNodes
{
  NodeDofView dofs; // (num_nodes, T), local rows of Z
  // (at least num local rows): 1 where the velocity is prescribed.
  ConstFlagView held;
  // Nodes that are free in some component, by colour. All ranks have the same number of colours.
  std::vector<IndexView> colours;

  int numNodes() const { return static_cast<int>(dofs.extent(0)); }
  int blockSize() const { return static_cast<int>(dofs.extent(1)); }
};
} // namespace asperity::tnnmg

#pragma once

#include "dynamics/fault/FaultMotion.hpp"

#include <vector>

namespace asperity::dynamics::test
{
// The peak slip rate of a fault whose body moves at v.
inline double peakSlipRateAt(fem::FaultSurface const& surface, Vector const& v)
{
  const BlockView w("asperity::test::w", surface.numNodes(), surface.numTangents());
  const NodeView V("asperity::test::V", surface.numNodes());
  gatherSlip(surface, v, w);
  slipRate(surface, w, V);
  return peakSlipRate(surface, V);
}

// A fault whose nodes have the given weights and, one after the other, the dofs 0, 1, 2, ..., T to
// a node. held(T num_nodes or more): 1 at held dofs.
inline fem::FaultSurface surfaceOf(std::vector<double> const& weights, int num_tangents,
                                   std::vector<int> const& held, fem::OtherSide other_side,
                                   RCP<const Communicator> const& communicator)
{
  std::vector<fem::FaultNode> nodes(weights.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes[i].copies = {static_cast<int>(i)};
    nodes[i].weight = weights[i];
    for (int k = 0; k < num_tangents; ++k) {
      nodes[i].dofs.push_back(static_cast<int>(i) * num_tangents + k);
    }
  }
  return {"fault", nodes,      num_tangents, {held, static_cast<int>(held.size())},
          {},      other_side, communicator};
}

// A fault of these dofs(num_nodes, T), with weight 1 and nothing held.
inline fem::FaultSurface surfaceWith(std::vector<std::vector<int>> const& dofs,
                                     RCP<const Communicator> const& communicator)
{
  std::vector<fem::FaultNode> nodes(dofs.size());
  int num_dofs = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes[i].copies = {static_cast<int>(i)};
    nodes[i].weight = 1;
    nodes[i].dofs = dofs[i];
    for (int dof : dofs[i]) {
      num_dofs = std::max(num_dofs, dof + 1);
    }
  }
  return {"fault",
          nodes,
          static_cast<int>(dofs.front().size()),
          {std::vector<int>(num_dofs, 0), num_dofs},
          {},
          fem::OtherSide::rigid_foundation,
          communicator};
}
} // namespace asperity::dynamics::test

#pragma once

#include "base/Views.hpp"
#include "multigrid/Hierarchy.hpp"
#include "tnnmg/hierarchy/NodeGraphs.hpp"

namespace asperity::tnnmg::detail
{
// The rows of P at the nonlinear nodes, T successive rows each, with a numbering of their own.
RCP<const CrsMatrix> rowsAtNodes(CrsMatrix const& P, NodeDofView const& fault);

// How the Hessians of the nonlinear nodes act on a level. Q: T rows for each nonlinear node that
// this rank owns; level: the graph of the level's matrix. Collective.
multigrid::HostAddedBlocks makeCoarseFault(RCP<const CrsMatrix> const& Q, int tangents,
                                           multigrid::HostGraph const& level, NodeMaps const& maps);
} // namespace asperity::tnnmg::detail

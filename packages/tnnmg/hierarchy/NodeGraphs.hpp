#pragma once

#include "base/Types.hpp"
#include "multigrid/Hierarchy.hpp"

#include <vector>

namespace asperity::tnnmg::detail
{
// The rows and columns of a node graph, among those of all ranks. The global id of a row is that of
// its node times row_size plus the component.
struct NodeMaps
{
  RCP<const Map> rows, domain;
  RCP<const Map> columns; // of owned and ghost columns; the domain on one rank
};

struct MappedGraph
{
  multigrid::HostGraph graph;
  NodeMaps maps;
};

// The union of the couplings of matrices with the same row and domain map. Collective.
MappedGraph makeNodeGraph(std::vector<RCP<const CrsMatrix>> const& matrices, int row_size,
                          int column_size);

// The entries of a matrix at the couplings of a graph that includes its own; zero elsewhere.
multigrid::HostBlocks blocksOf(multigrid::HostGraph const& graph, NodeMaps const& maps,
                               CrsMatrix const& matrix);

// (num_rows) the global ids of the nodes of the rows, modulo 2^31.
std::vector<int> idsOf(multigrid::HostGraph const& graph, NodeMaps const& maps);

// The rows of the coarsest level. SolveError on all ranks if there are too many. Collective.
multigrid::CoarsestRows coarsestRows(NodeMaps const& maps);

multigrid::SumOverRanks sumOver(RCP<const Communicator> const& communicator);
} // namespace asperity::tnnmg::detail

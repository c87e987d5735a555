#pragma once

#include "multigrid/NodeGraph.hpp"

#include <vector>

namespace asperity::multigrid
{
// Numbers of nodes such that those of one part follow one another.
struct RowParts
{
  std::vector<int> row_of_node; // (num_rows), or empty: each node has its own number
  std::vector<int> begins;      // (num parts + 1) the first row of each part
};
// Colours, of which no two nodes are coupled: each node takes the first one that no node before it
// has to which it is coupled.
RowParts colours(HostGraph const& graph);
// Regions that lie together and have about equally many couplings, at most `most`. A region is
// halved, again and again, at a distance from one of its ends, counted in couplings. Within a
// region nodes keep their order.
RowParts regions(HostGraph const& graph, int most);

// A graph with other numbers of its nodes.
struct Renumbered
{
  HostGraph graph;
  std::vector<int> coupling_of_given; // (num couplings)
};
// row_of_node, column_of_node: of the rows, and of owned columns; empty: as they are.
Renumbered renumbered(HostGraph const& graph, std::vector<int> const& row_of_node,
                      std::vector<int> const& column_of_node);
// The blocks, of `size` numbers each, in the order of the renumbered graph.
HostBlocks renumbered(HostBlocks const& blocks, std::vector<int> const& coupling_of_given,
                      int size);
} // namespace asperity::multigrid

#pragma once

#include "multigrid/NodeGraph.hpp"

#include <vector>

namespace asperity::multigrid
{
// Numbers the nodes of a graph so that those of one colour, of which no two are coupled, follow one
// another.
struct Colours
{
  std::vector<int> row_of_node; // (num_rows)
  std::vector<int> begins;      // (num colours + 1) the first row of each colour
};
// Each node takes the first colour that no node before it has to which it is coupled.
Colours colour(HostGraph const& graph);

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

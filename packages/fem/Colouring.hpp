#pragma once

#include "base/Types.hpp"
#include "base/Views.hpp"

#include <vector>

namespace asperity::fem
{
// This rank's nodes of each colour, ascending; all ranks have the same number of colours. No two
// nodes of one colour are neighbours, also across ranks: they may be smoothed at the same time.
using Colouring = std::vector<std::vector<LocalOrdinal>>;

// Colours a graph whose rows are nodes: symmetric, square, fill-complete, self loops allowed, every
// row on one rank. Jones and Plassmann (1993) with weights hashed from the global ids: the same
// colours on any number of ranks.
Colouring colourNodes(CrsGraph const& graph);

// Colours nodes, numbered as in dofs, by what couples their rows in the graph of a matrix, without
// those whose rows are all held. held(num local rows, or more) is 1 at a held row. The number of
// colours is the same on every rank.
std::vector<IndexView> colourFreeNodes(CrsGraph const& graph, NodeDofView const& dofs,
                                       std::vector<int> const& held);
} // namespace asperity::fem

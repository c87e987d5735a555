#pragma once

#include "base/Types.hpp"
#include "tnnmg/LinearCorrection.hpp"

#include <vector>

namespace asperity::tnnmg
{
// Nodes of one colour are not neighbours, on no rank: they may be smoothed at the same time.
struct Colouring
{
  int num_colours = 0; // the same on every rank
  std::vector<std::vector<LocalOrdinal>>
    rows;                  // rows[colour]: this rank's nodes of that colour, ascending
  std::vector<int> colour; // colour[local row]
};

// Colours a graph whose rows are nodes: symmetric, square, fill-complete, self loops allowed, every
// row on one rank. Jones and Plassmann (1993) with weights hashed from the global ids: the same
// colours on any number of ranks.
Colouring colourNodes(CrsGraph const& graph);

// Colours the nonlinear nodes, numbered as in dofs, by what couples them in Z (stored zeros count).
Colouring colourNodes(CrsMatrix const& Z, NonlinearDofView const& dofs);
} // namespace asperity::tnnmg

#pragma once

#include "base/Types.hpp"

#include <vector>

namespace asperity::fem
{
// y = A x; all of owned dofs. y may not be an x of any product beside it.
struct MatrixProduct
{
  CrsMatrix const& A;
  Vector const& x;
  Vector& y;
};

// All of them. Matrices on one graph that needs no other rank's values are read in one pass, which
// reads the graph once: it takes a third of what a matrix has to be read for. At most four.
// Collective.
void multiply(std::vector<MatrixProduct> const& products);
} // namespace asperity::fem

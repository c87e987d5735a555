#pragma once

#include "base/Types.hpp"

#include <vector>

namespace asperity::fem
{
// y = A x, all on the owned dofs. y must not be the x of any product in the same call.
struct MatrixProduct
{
  CrsMatrix const& A;
  Vector const& x;
  Vector& y;
};

// Computes all the products. Matrices on the graph of the first one are multiplied in one pass if
// it has no ghost columns: its column indices, a third of the data of a matrix, are read once. At
// most four matrices on that graph. Collective.
void multiply(std::vector<MatrixProduct> const& products);
} // namespace asperity::fem

#pragma once

#include "base/Types.hpp"

#include <vector>

namespace asperity
{
// y = A x on the owned dofs; x may also be on A's own column map, with its ghosts. y must not be
// the x of any product in the same call.
struct MatrixProduct
{
  CrsMatrix const& A;
  Vector const& x;
  Vector& y;
};

// Computes all the products. Matrices on the graph of the first one are multiplied in one pass if
// their vectors do not lack ghosts: column indices, a third of the data of a matrix, are read once.
// At most four matrices on that graph. Collective.
void multiply(std::vector<MatrixProduct> const& products);
} // namespace asperity

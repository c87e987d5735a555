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

// Computes all the products. Matrices that share a graph without ghost columns are multiplied in
// one pass, which reads the graph once: its column indices are a third of the data of a matrix. At
// most four matrices on one graph. Collective.
void multiply(std::vector<MatrixProduct> const& products);
} // namespace asperity::fem

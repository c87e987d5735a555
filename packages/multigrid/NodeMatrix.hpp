#pragma once

#include "multigrid/NodeGraph.hpp"
#include "multigrid/Schedule.hpp"

#include <cstddef>
#include <vector>

namespace asperity::multigrid
{
// y += times A x
void multiplyAdd(MatrixGraph const& graph, Schedule const& schedule, NodeBlocks const& A,
                 NodeVector const& x, NodeVector const& y, float times = 1);
// y += A x
void multiplyAdd(NodeGraph const& graph, Schedule const& schedule, NodeBlocks const& A,
                 NodeVector const& x, NodeVector const& y);

// Products with the transpose of a matrix whose rows have the given schedule. Chunks of rows add to
// vectors of their own, which reads the matrix row by row; colours are for devices, where each
// column gathers what its rows have.
class TransposedProduct
{
public:
  TransposedProduct() = default;
  TransposedProduct(HostGraph const& graph, Schedule const& schedule);

  // y(columns) = A^T x. `parts` are results of chunks but the first, overwritten.
  void multiply(NodeGraph const& graph, Schedule const& schedule, NodeBlocks const& A,
                NodeVector const& x, NodeVector const& y, std::vector<NodeVector>& parts) const;

  // What a product reads in addition to the vectors.
  std::size_t bytes() const;

private:
  // For each column its rows, ascending, and their couplings: (num columns + 1) where they begin.
  IndexView first_, rows_, couplings_;
};
} // namespace asperity::multigrid

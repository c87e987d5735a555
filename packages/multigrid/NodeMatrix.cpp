#include "multigrid/NodeMatrix.hpp"

#include "multigrid/NodeKernels.hpp"

namespace asperity::multigrid
{
int NodeGraph::find(int row, int column) const
{
  auto const begin = columns.begin() + first[row], end = columns.begin() + first[row + 1];
  auto const place = std::lower_bound(begin, end, column);
  return place != end && *place == column ? static_cast<int>(place - columns.begin()) : -1;
}

void NodeGraph::share(NodeVector& x) const
{
  if (ghosts) {
    ghosts->share(x);
  }
}

void NodeGraph::gather(NodeVector& x) const
{
  if (ghosts) {
    ghosts->gather(x);
  }
}

void multiplyAdd(NodeGraph const& graph, NodeBlocks const& A, NodeVector const& x, NodeVector& y)
{
  withBlockSizes(graph.row_size, graph.column_size, [&](auto rows, auto columns) {
    constexpr int R = decltype(rows)::value, C = decltype(columns)::value;
    for (int row = 0; row < graph.num_rows; ++row) {
      RowSums<R, C> sum;
      for (int k = graph.first[row]; k < graph.first[row + 1]; ++k) {
        sum.add(&A[static_cast<std::size_t>(k) * R * C], &x[graph.columns[k] * C]);
      }
      for (int r = 0; r < R; ++r) {
        y[row * R + r] += sum[r];
      }
    }
  });
}

void multiplyTransposed(NodeGraph const& graph, NodeBlocks const& A, NodeVector const& x,
                        NodeVector& y)
{
  std::fill(y.begin(), y.end(), 0.f);
  withBlockSizes(graph.row_size, graph.column_size, [&](auto rows, auto columns) {
    constexpr int R = decltype(rows)::value, C = decltype(columns)::value;
    for (int row = 0; row < graph.num_rows; ++row) {
      for (int k = graph.first[row]; k < graph.first[row + 1]; ++k) {
        addTransposed<R, C>(&A[static_cast<std::size_t>(k) * R * C], &x[row * R],
                            &y[graph.columns[k] * C]);
      }
    }
  });
}
} // namespace asperity::multigrid

#include "multigrid/NodeMatrix.hpp"

#include "multigrid/NodeKernels.hpp"

#include <numeric>

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

Transpose::Transpose(NodeGraph const& graph, int num_threads)
    : first(graph.num_columns + 1, 0)
    , couplings(graph.columns.size())
    , rows(graph.columns.size())
{
  for (int column : graph.columns) {
    ++first[column + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  auto next = first;
  for (int row = 0; row < graph.num_rows; ++row) {
    for (int k = graph.first[row]; k < graph.first[row + 1]; ++k) {
      const int place = next[graph.columns[k]]++;
      couplings[place] = k;
      rows[place] = row;
    }
  }
  chunks = Chunks(first, num_threads);
}

void multiplyAdd(NodeGraph const& graph, Chunks const& chunks, NodeBlocks const& A,
                 NodeVector const& x, NodeVector& y)
{
  withBlockSizes(graph.row_size, graph.column_size, [&](auto rows, auto columns) {
    constexpr int R = decltype(rows)::value, C = decltype(columns)::value;
    chunks.forEachRow([&](int row) {
      RowSums<R, C> sum;
      for (int k = graph.first[row]; k < graph.first[row + 1]; ++k) {
        sum.add(&A[static_cast<std::size_t>(k) * R * C], &x[graph.columns[k] * C]);
      }
      for (int r = 0; r < R; ++r) {
        y[row * R + r] += sum[r];
      }
    });
  });
}

void multiplyTransposed(NodeGraph const& graph, Transpose const& transpose, NodeBlocks const& A,
                        NodeVector const& x, NodeVector& y)
{
  withBlockSizes(graph.row_size, graph.column_size, [&](auto rows, auto columns) {
    constexpr int R = decltype(rows)::value, C = decltype(columns)::value;
    transpose.chunks.forEachRow([&](int column) {
      Packed<C> sum;
      for (int i = transpose.first[column]; i < transpose.first[column + 1]; ++i) {
        addTransposed<R, C>(&A[static_cast<std::size_t>(transpose.couplings[i]) * R * C],
                            &x[transpose.rows[i] * R], sum);
      }
      sum.store(&y[column * C]);
    });
  });
}
} // namespace asperity::multigrid

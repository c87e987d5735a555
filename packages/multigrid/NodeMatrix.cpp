#include "multigrid/NodeMatrix.hpp"

#include "multigrid/NodeKernels.hpp"

#include <algorithm>
#include <functional>

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

void multiplyTransposed(NodeGraph const& graph, Chunks const& chunks, NodeBlocks const& A,
                        NodeVector const& x, NodeVector& y, std::vector<NodeVector>& parts)
{
  parts.resize(chunks.count() - 1);
  withBlockSizes(graph.row_size, graph.column_size, [&](auto rows, auto columns) {
    constexpr int R = decltype(rows)::value, C = decltype(columns)::value;
    chunks.forEachChunk([&](int chunk, int begin, int end) {
      auto& to = chunk == 0 ? y : parts[chunk - 1];
      to.assign(y.size(), 0.f);
      for (int row = begin; row < end; ++row) {
        for (int k = graph.first[row]; k < graph.first[row + 1]; ++k) {
          addTransposed<R, C>(&A[static_cast<std::size_t>(k) * R * C], &x[row * R],
                              &to[graph.columns[k] * C]);
        }
      }
    });
  });
  for (auto const& part : parts) {
    std::transform(y.begin(), y.end(), part.begin(), y.begin(), std::plus<float>());
  }
}
} // namespace asperity::multigrid

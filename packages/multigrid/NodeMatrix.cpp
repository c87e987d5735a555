#include "multigrid/NodeMatrix.hpp"

#include "multigrid/NodeKernels.hpp"

#include <algorithm>
#include <functional>

namespace asperity::multigrid
{
namespace
{
template <int R, int C>
struct AddRow
{
  int const *first, *columns;
  float const *A, *x;
  float* y;
  KOKKOS_FUNCTION void operator()(int row, int, int) const
  {
    RowSums<R, C> sum;
    for (int k = first[row]; k < first[row + 1]; ++k) {
      sum.add(A + static_cast<std::size_t>(k) * R * C, x + columns[k] * C);
    }
    for (int r = 0; r < R; ++r) {
      y[row * R + r] += sum[r];
    }
  }
};

template <int N>
struct AddMatrixRow
{
  int const *lower, *diagonal, *upper, *columns;
  float const *A, *x;
  float* y;
  float times;
  KOKKOS_FUNCTION void operator()(int row, int, int) const
  {
    RowSums<N, N> sum;
    add(sum, lower[row], lower[row + 1]);
    add(sum, diagonal[row], diagonal[row] < 0 ? -1 : diagonal[row] + 1);
    add(sum, upper[row], upper[row + 1]);
    for (int c = 0; c < N; ++c) {
      y[row * N + c] += times * sum[c];
    }
  }
  KOKKOS_FUNCTION void add(RowSums<N, N>& sum, int from, int to) const
  {
    for (int k = from; k < to; ++k) {
      sum.add(A + static_cast<std::size_t>(k) * N * N, x + columns[k] * N);
    }
  }
};

// A column of a matrix.
template <int R, int C>
struct GatherColumn
{
  IndexView first, rows, couplings;
  float const *A, *x;
  float* y;
  KOKKOS_FUNCTION void operator()(int column) const
  {
    float sum[C + 4] = {}; // for loads of four
    for (int i = first(column); i < first(column + 1); ++i) {
      addTransposed<R, C>(A + static_cast<std::size_t>(couplings(i)) * R * C, x + rows(i) * R, sum);
    }
    for (int c = 0; c < C; ++c) {
      y[column * C + c] = sum[c];
    }
  }
};
} // namespace

void multiplyAdd(MatrixGraph const& graph, Schedule const& schedule, NodeBlocks const& A,
                 NodeVector const& x, NodeVector const& y, float times)
{
  withBlockSizes(graph.row_size, graph.column_size, [&](auto rows, auto) {
    constexpr int N = decltype(rows)::value;
    schedule.forEach(AddMatrixRow<N>{graph.lower.data(), graph.diagonal.data(), graph.upper.data(),
                                     graph.columns.data(), A.data(), x.data(), y.data(), times});
  });
}

void multiplyAdd(NodeGraph const& graph, Schedule const& schedule, NodeBlocks const& A,
                 NodeVector const& x, NodeVector const& y)
{
  withBlockSizes(graph.row_size, graph.column_size, [&](auto rows, auto columns) {
    constexpr int R = decltype(rows)::value, C = decltype(columns)::value;
    schedule.forEach(
      AddRow<R, C>{graph.first.data(), graph.columns.data(), A.data(), x.data(), y.data()});
  });
}

TransposedProduct::TransposedProduct(HostGraph const& graph, Schedule const& schedule)
{
  if (!schedule.isColoured()) {
    return;
  }
  std::vector<int> first(graph.num_columns + 1, 0);
  for (int column : graph.columns) {
    ++first[column + 1];
  }
  for (int column = 0; column < graph.num_columns; ++column) {
    first[column + 1] += first[column];
  }
  auto next = first;
  std::vector<int> rows(graph.columns.size()), couplings(graph.columns.size());
  for (int row = 0; row < graph.num_rows; ++row) {
    for (int k = graph.first[row]; k < graph.first[row + 1]; ++k) {
      const int place = next[graph.columns[k]]++;
      rows[place] = row;
      couplings[place] = k;
    }
  }
  first_ = indices(first);
  rows_ = indices(rows);
  couplings_ = indices(couplings);
}

void TransposedProduct::multiply(NodeGraph const& graph, Schedule const& schedule,
                                 NodeBlocks const& A, NodeVector const& x, NodeVector const& y,
                                 std::vector<NodeVector>& parts) const
{
  withBlockSizes(graph.row_size, graph.column_size, [&](auto rows, auto columns) {
    constexpr int R = decltype(rows)::value, C = decltype(columns)::value;
    if (schedule.isColoured()) {
      Kokkos::parallel_for(
        "asperity::multigrid::gather", RangePolicy(0, graph.num_columns),
        GatherColumn<R, C>{first_, rows_, couplings_, A.data(), x.data(), y.data()});
      return;
    }
    for (auto i = static_cast<int>(parts.size()); i + 1 < schedule.numParts(); ++i) {
      parts.push_back(makeNumbers(y.extent(0)));
    }
    int const *first = graph.first.data(), *column_of = graph.columns.data();
    schedule.forEachChunk([&](int chunk, int begin, int end) {
      auto const& to = chunk == 0 ? y : parts[chunk - 1];
      std::fill_n(to.data(), to.extent(0), 0.f);
      for (int row = begin; row < end; ++row) {
        for (int k = first[row]; k < first[row + 1]; ++k) {
          addTransposed<R, C>(A.data() + static_cast<std::size_t>(k) * R * C, x.data() + row * R,
                              to.data() + column_of[k] * C);
        }
      }
    });
    const detail::KernelRegion region;
    for (auto const& part : parts) {
      std::transform(y.data(), y.data() + y.extent(0), part.data(), y.data(), std::plus<float>());
    }
  });
}

std::size_t TransposedProduct::bytes() const
{
  return sizeof(int) * (first_.extent(0) + rows_.extent(0) + couplings_.extent(0));
}
} // namespace asperity::multigrid

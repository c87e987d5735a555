#pragma once

#include "multigrid/Hierarchy.hpp"
#include "multigrid/NodeKernels.hpp"

namespace asperity::multigrid
{
// Sweeps of block Gauss-Seidel for A x = b on one level, with blocks of N rows: row by row within
// each of the level's chunks, on which threads of the host work at the same time. What a row takes
// from other chunks and from ghosts of other ranks is from before the sweep. Below, L and U are the
// couplings with earlier and later rows of the own chunk, G those with other chunks and ranks.
template <int N>
class Sweeps
{
public:
  // inverse: of the diagonal blocks, zero where not free.
  Sweeps(Level const& level, NodeBlocks const& A, NodeBlocks const& inverse)
      : level_(level)
      , A_(A)
      , inverse_(inverse)
  {
  }

  // The forward sweep from x = 0, and the residual after it, -(U + G) x.
  void forward(NodeVector const& b, NodeVector& x, NodeVector& residual) const;
  // The backward sweep. Stores b - (L + G) x_before in `residual`, with the x before the sweep.
  // `before` is overwritten if there are several chunks.
  void backward(NodeVector const& b, NodeVector& x, NodeVector& residual, NodeVector& before) const;
  // A x after the backward sweep, which solved (D + U) x = b - (L + G) x_before, from the residual
  // that it stored: only the couplings L + G have to be read.
  void image(NodeVector& x, NodeVector& residual) const;
  // Sets the components that are not free to zero.
  void clearHeld(NodeVector& x) const;

private:
  // The blocks of a row are fetched into the cache this number of rows before they are used. A
  // sweep skips half of each row or goes backward, which the processor does not predict.
  static constexpr int rows_ahead = 8;

  void fetch(int first, int end) const;
  // The first coupling of a row with its own chunk, which begins with the row `begin`.
  int firstWithin(int begin, int row) const
  {
    int k = level_.graph.first[row];
    while (k < level_.before[row] && level_.graph.columns[k] < begin) {
      ++k;
    }
    return k;
  }
  void add(RowSums<N, N>& sum, int k, NodeVector const& x) const
  {
    sum.add(&A_[static_cast<std::size_t>(k) * N * N], &x[level_.graph.columns[k] * N]);
  }
  void solve(int row, float const (&rest)[N], NodeVector& x) const
  {
    multiplySymmetric<N>(&inverse_[static_cast<std::size_t>(row) * N * N], rest, &x[row * N]);
  }

  Level const& level_;
  NodeBlocks const &A_, &inverse_;
};

// Fetches the blocks first <= k < end of A into the cache.
template <int N>
void Sweeps<N>::fetch(int first, int end) const
{
  constexpr std::size_t numbers_of_a_line = 16; // 64 bytes
  for (std::size_t i = static_cast<std::size_t>(first) * N * N;
       i < static_cast<std::size_t>(end) * N * N; i += numbers_of_a_line) {
    __builtin_prefetch(&A_[i]);
  }
}

template <int N>
void Sweeps<N>::forward(NodeVector const& b, NodeVector& x, NodeVector& residual) const
{
  auto const& graph = level_.graph;
  level_.chunks.forEach([&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      if (const int next = row + rows_ahead; next < end) {
        fetch(graph.first[next], level_.before[next]);
      }
      RowSums<N, N> before;
      for (int k = firstWithin(begin, row); k < level_.before[row]; ++k) {
        add(before, k, x);
      }
      float rest[N];
      for (int c = 0; c < N; ++c) {
        rest[c] = b[row * N + c] - before[c];
      }
      solve(row, rest, x);
    }
  });
  graph.share(x);
  level_.chunks.forEach([&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      if (const int next = row + rows_ahead; next < end) {
        fetch(level_.after[next], graph.first[next + 1]);
      }
      RowSums<N, N> rest;
      for (int k = graph.first[row]; k < firstWithin(begin, row); ++k) {
        add(rest, k, x);
      }
      for (int k = level_.after[row]; k < graph.first[row + 1]; ++k) {
        add(rest, k, x);
      }
      for (int c = 0; c < N; ++c) {
        residual[row * N + c] = -rest[c];
      }
    }
  });
}

template <int N>
void Sweeps<N>::backward(NodeVector const& b, NodeVector& x, NodeVector& residual,
                         NodeVector& before) const
{
  auto const& graph = level_.graph;
  graph.share(x);
  const bool are_several = level_.chunks.count() > 1;
  if (are_several) {
    before = x;
  }
  NodeVector const& x_before = are_several ? before : x;
  level_.chunks.forEach([&](int begin, int end) {
    for (int row = end - 1; row >= begin; --row) {
      if (const int next = row - rows_ahead; next >= begin) {
        fetch(graph.first[next], graph.first[next + 1]);
      }
      RowSums<N, N> old, updated;
      for (int k = graph.first[row]; k < level_.before[row]; ++k) {
        add(old, k, x_before);
      }
      int k = level_.after[row];
      for (; k < graph.first[row + 1] && graph.columns[k] < end; ++k) {
        add(updated, k, x);
      }
      for (; k < graph.first[row + 1]; ++k) {
        add(old, k, x_before);
      }
      float rest[N];
      for (int c = 0; c < N; ++c) {
        residual[row * N + c] = b[row * N + c] - old[c];
        rest[c] = residual[row * N + c] - updated[c];
      }
      solve(row, rest, x);
    }
  });
}

template <int N>
void Sweeps<N>::image(NodeVector& x, NodeVector& residual) const
{
  auto const& graph = level_.graph;
  graph.share(x);
  level_.chunks.forEach([&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      if (const int next = row + rows_ahead; next < end) {
        fetch(graph.first[next], level_.before[next]);
      }
      RowSums<N, N> sum;
      for (int k = graph.first[row]; k < level_.before[row]; ++k) {
        add(sum, k, x);
      }
      for (int k = graph.first[row + 1]; k > level_.after[row] && graph.columns[k - 1] >= end;
           --k) {
        add(sum, k - 1, x);
      }
      for (int c = 0; c < N; ++c) {
        residual[row * N + c] += sum[c];
      }
    }
  });
  clearHeld(residual);
}

template <int N>
void Sweeps<N>::clearHeld(NodeVector& x) const
{
  level_.chunks.forEachRow([&](int row) {
    float const* diagonal = &inverse_[static_cast<std::size_t>(row) * N * N];
    for (int c = 0; c < N; ++c) {
      if (diagonal[c * N + c] == 0) {
        x[row * N + c] = 0;
      }
    }
  });
}
} // namespace asperity::multigrid

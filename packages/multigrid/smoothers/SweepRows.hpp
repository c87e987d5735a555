#pragma once

#include "multigrid/NodeKernels.hpp"
#include "multigrid/Smoother.hpp"

#include <cstddef>

// The kernels of sweeps over the rows of a level.

namespace asperity::multigrid
{
// The rows of a level's matrix A with blocks of N rows, for kernels. Below, a row is taken in order
// with those from `begin` to `end` (Schedule); D is its block with itself, L and U are its
// couplings with earlier and later ones of these, G those with others and with ghosts of other
// ranks. A sweep solves with D + E, where E is diagonal (DampRow).
template <int N>
struct BlockRows
{
  int const *lower, *upper, *columns; // of MatrixGraph
  float const *A, *inverse;           // inverse of D + E, zero where not free
  float const* E;                     // (rows), or null if it is zero

  explicit BlockRows(LevelMatrix const& matrix)
      : lower(matrix.level.graph.lower.data())
      , upper(matrix.level.graph.upper.data())
      , columns(matrix.level.graph.columns.data())
      , A(matrix.A.data())
      , inverse(matrix.inverse.data())
      , E(matrix.damping.extent(0) > 0 ? matrix.damping.data() : nullptr)
  {
  }

  // The blocks of a row are fetched into the cache this number of rows before they are used: rows
  // are too short for a processor to do it by itself.
  static constexpr int rows_ahead = 8;

  // Fetches the blocks from <= k < to into the cache of the host.
  KOKKOS_FUNCTION void fetch([[maybe_unused]] int from, [[maybe_unused]] int to) const
  {
#if !defined(__CUDA_ARCH__) && !defined(__HIP_DEVICE_COMPILE__) && !defined(__SYCL_DEVICE_ONLY__)
    constexpr std::size_t numbers_of_a_line = 16; // 64 bytes
    for (auto i = static_cast<std::size_t>(from) * N * N; i < static_cast<std::size_t>(to) * N * N;
         i += numbers_of_a_line) {
      __builtin_prefetch(A + i);
    }
#endif
  }
  // The first coupling of L.
  KOKKOS_FUNCTION int firstWithin(int begin, int row) const
  {
    int k = lower[row];
    while (k < lower[row + 1] && columns[k] < begin) {
      ++k;
    }
    return k;
  }
  KOKKOS_FUNCTION void add(RowSums<N, N>& sum, int k, float const* x) const
  {
    sum.add(A + static_cast<std::size_t>(k) * N * N, x + columns[k] * N);
  }
  // to += E x
  KOKKOS_FUNCTION void addDamped(int row, float const* x, float* to) const
  {
    for (int i = row * N; E != nullptr && i < (row + 1) * N; ++i) {
      to[i] += E[i] * x[i];
    }
  }
  KOKKOS_FUNCTION void subtractDamped(int row, float const* x, float* from) const
  {
    for (int i = row * N; E != nullptr && i < (row + 1) * N; ++i) {
      from[i] -= E[i] * x[i];
    }
  }
  KOKKOS_FUNCTION void solve(int row, float const (&rest)[N], float* x) const
  {
    multiplySymmetric<N>(inverse + static_cast<std::size_t>(row) * N * N, rest, x + row * N);
  }
};

// A row of the forward sweep from x = 0. A call for each row would cost several percent of a cycle.
template <int N>
struct ForwardRow
{
  BlockRows<N> matrix;
  float const* b;
  float* x;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(int row, int begin, int end) const
  {
    if (const int next = row + matrix.rows_ahead; next < end) {
      matrix.fetch(matrix.lower[next], matrix.lower[next + 1]);
    }
    RowSums<N, N> before;
    for (int k = matrix.firstWithin(begin, row); k < matrix.lower[row + 1]; ++k) {
      matrix.add(before, k, x);
    }
    float rest[N];
    for (int c = 0; c < N; ++c) {
      rest[c] = b[row * N + c] - before[c];
    }
    matrix.solve(row, rest, x);
  }
};

// A row of the residual after it, E x - (U + G) x.
template <int N>
struct ResidualRow
{
  BlockRows<N> matrix;
  float const* x;
  float* residual;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(int row, int begin, int end) const
  {
    if (const int next = row + matrix.rows_ahead; next < end) {
      matrix.fetch(matrix.upper[next], matrix.upper[next + 1]);
    }
    RowSums<N, N> rest;
    for (int k = matrix.lower[row]; k < matrix.firstWithin(begin, row); ++k) {
      matrix.add(rest, k, x);
    }
    for (int k = matrix.upper[row]; k < matrix.upper[row + 1]; ++k) {
      matrix.add(rest, k, x);
    }
    for (int c = 0; c < N; ++c) {
      residual[row * N + c] = -rest[c];
    }
    matrix.addDamped(row, x, residual);
  }
};

// A row of the backward sweep; x_before is x from before the sweep, or x itself where the rows of
// L and G are swept later or not at all.
template <int N>
struct BackwardRow
{
  BlockRows<N> matrix;
  float const *b, *x_before;
  float *x, *residual; // b - (L + G) x_before + E (x_before - x)
  KOKKOS_FORCEINLINE_FUNCTION void operator()(int row, int begin, int end) const
  {
    if (const int next = row - matrix.rows_ahead; next >= begin) {
      matrix.fetch(matrix.lower[next], matrix.lower[next + 1]);
      matrix.fetch(matrix.upper[next], matrix.upper[next + 1]);
    }
    RowSums<N, N> old, updated;
    for (int k = matrix.lower[row]; k < matrix.lower[row + 1]; ++k) {
      matrix.add(old, k, x_before);
    }
    int k = matrix.upper[row];
    for (; k < matrix.upper[row + 1] && matrix.columns[k] < end; ++k) {
      matrix.add(updated, k, x);
    }
    for (; k < matrix.upper[row + 1]; ++k) {
      matrix.add(old, k, x_before);
    }
    for (int c = 0; c < N; ++c) {
      residual[row * N + c] = b[row * N + c] - old[c];
    }
    matrix.addDamped(row, x, residual);
    float rest[N];
    for (int c = 0; c < N; ++c) {
      rest[c] = residual[row * N + c] - updated[c];
    }
    matrix.solve(row, rest, x);
    matrix.subtractDamped(row, x, residual);
  }
};

// A row of A x after the backward sweep: that solved (D + E + U) x = b - (L + G) x_before +
// E x_before, so that only (L + G) x has to be added to what it stored.
template <int N>
struct ImageRow
{
  BlockRows<N> matrix;
  float const* x;
  float* residual;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(int row, int, int end) const
  {
    if (const int next = row + matrix.rows_ahead; next < end) {
      matrix.fetch(matrix.lower[next], matrix.lower[next + 1]);
    }
    RowSums<N, N> sum;
    for (int k = matrix.lower[row]; k < matrix.lower[row + 1]; ++k) {
      matrix.add(sum, k, x);
    }
    for (int k = matrix.upper[row + 1]; k > matrix.upper[row] && matrix.columns[k - 1] >= end;
         --k) {
      matrix.add(sum, k - 1, x);
    }
    for (int c = 0; c < N; ++c) {
      residual[row * N + c] += sum[c];
    }
  }
};

// How a sweep takes its rows: together with the others of its chunk or with other colours, which is
// Gauss-Seidel within them, or each alone, so that whatever it takes from others is from before the
// sweep, which is Jacobi.
template <class Row>
struct GaussSeidelRows : Row
{
  static constexpr bool is_jacobi = false;
};
template <class Row>
struct JacobiRows : Row
{
  static constexpr bool is_jacobi = true;
  KOKKOS_FORCEINLINE_FUNCTION void operator()(int row, int, int) const
  {
    Row::operator()(row, row, row + 1);
  }
};
} // namespace asperity::multigrid

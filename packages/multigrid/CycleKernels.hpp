#pragma once

#include "multigrid/Cycle.hpp"
#include "multigrid/NodeKernels.hpp"

#include <cstddef>

// The kernels of Cycle. Those of a row take the range of a sweep, which they do
// not need.
namespace asperity::multigrid
{
// Renumbers a vector on the nodes of the finest level, with `size` numbers each.
struct Renumber
{
  IndexView row_of_node;
  int size;
  KOKKOS_FUNCTION int operator()(int number) const
  {
    return row_of_node(number / size) * size + number % size;
  }
};

struct KeepNumber
{
  KOKKOS_FUNCTION int operator()(int number) const { return number; }
};

// Calls work with what gives the row of a number of a node.
template <class Work>
void withNumbers(IndexView const& row_of_node, int size, Work const& work)
{
  if (row_of_node.extent(0) == 0) {
    work(KeepNumber());
  } else {
    work(Renumber{row_of_node, size});
  }
}

template <class Numbers>
struct CopyFlags
{
  Numbers row;
  IndexView given;
  FlagView result;
  KOKKOS_FUNCTION void operator()(int i) const { result(row(i)) = given(i); }
};

template <class Numbers>
struct CopyDofs
{
  Numbers row;
  Cycle::Dofs given;
  Kokkos::View<int**, Kokkos::LayoutRight, MemorySpace> result;
  KOKKOS_FUNCTION void operator()(int node) const
  {
    for (int t = 0; t < result.extent_int(1); ++t) {
      result(node, t) = row(given(node, t));
    }
  }
};

template <class Numbers>
struct ToRows
{
  Numbers row;
  ConstNodeView given;
  double by;
  float* x;
  KOKKOS_FUNCTION void operator()(int i) const { x[row(i)] = static_cast<float>(given(i) / by); }
};

template <class Numbers>
struct FromRows
{
  Numbers row;
  float const* x;
  double times;
  NodeView result;
  KOKKOS_FUNCTION void operator()(int i) const { result(i) = times * x[row(i)]; }
};

// Calls row for some rows.
template <class Row>
struct AtRows
{
  IndexView rows;
  Row row;
  KOKKOS_FUNCTION void operator()(int i) const { row(rows(i), 0, 0); }
};

// sum_k weight_k term_k
struct WeightedTerms
{
  float const* terms[Cycle::most_terms];
  double weights[Cycle::most_terms];
  int count;
};

// A row of a coarse matrix, without added blocks. size: of a block.
struct SumTermsRow
{
  WeightedTerms weighted;
  int const *lower, *diagonal, *upper; // of MatrixGraph
  int size;
  float* A;
  KOKKOS_FUNCTION void operator()(int row, int, int) const
  {
    sum(lower[row], lower[row + 1]);
    sum(diagonal[row], diagonal[row] < 0 ? -1 : diagonal[row] + 1);
    sum(upper[row], upper[row + 1]);
  }
  // Sums the terms of the couplings from <= k < to.
  KOKKOS_FUNCTION void sum(int from, int to) const
  {
    const auto end = static_cast<std::ptrdiff_t>(to) * size;
    for (auto i = static_cast<std::ptrdiff_t>(from) * size; i < end; ++i) {
      double result = 0;
      for (int k = 0; k < weighted.count; ++k) {
        result += weighted.weights[k] * weighted.terms[k][i];
      }
      A[i] = static_cast<float>(result);
    }
  }
};

// Adds the damping E of a row (Damping.hpp), or nothing where it is null.
template <int N>
KOKKOS_INLINE_FUNCTION void addDamping(float const* E, int row, double (&block)[N][N])
{
  for (int c = 0; c < N && E != nullptr; ++c) {
    block[c][c] += E[row * N + c];
  }
}

// The inverse of the diagonal block of a coarse row, damped; zero without one.
template <int N>
struct InvertRow
{
  int const* diagonal; // of MatrixGraph
  float const *A, *E;
  float* inverse;
  KOKKOS_FUNCTION void operator()(int row, int, int) const
  {
    double block[N][N] = {};
    for (int i = 0; diagonal[row] >= 0 && i < N * N; ++i) {
      block[i / N][i % N] = A[static_cast<std::size_t>(diagonal[row]) * N * N + i];
    }
    addDamping(E, row, block);
    invertFree(block, AllFree(), inverse + static_cast<std::size_t>(row) * N * N);
  }
};

// The components of a fine node that are neither held nor removed.
template <int N>
struct FreeComponents
{
  int const* held; // of the node
  bool removed[N];
  KOKKOS_FUNCTION bool operator()(int c) const { return !held[c] && !removed[c]; }
};

// Sets the components of a row that are not free to zero.
template <int N>
struct ClearHeldRow
{
  float const* inverse;
  float* x;
  KOKKOS_FUNCTION void operator()(int row, int, int) const
  {
    float const* diagonal = inverse + static_cast<std::size_t>(row) * N * N;
    for (int c = 0; c < N; ++c) {
      if (diagonal[c * N + c] == 0) {
        x[row * N + c] = 0;
      }
    }
  }
};

// The inverse of the diagonal block of a fine row, of Z alone, damped.
template <int N>
struct InvertFinest
{
  int const* diagonal; // of MatrixGraph; every row has one
  float const *A, *E;
  int const* held;
  float* inverse;
  KOKKOS_FUNCTION void operator()(int row, int, int) const
  {
    double block[N][N] = {};
    invert(row, A + static_cast<std::size_t>(diagonal[row]) * N * N, block, {held + row * N, {}});
  }
  // added + Z, the block of Z
  KOKKOS_FUNCTION void invert(int row, float const* Z, double (&block)[N][N],
                              FreeComponents<N> const& free) const
  {
    for (int i = 0; i < N * N; ++i) {
      block[i / N][i % N] = Z[i] + block[i / N][i % N];
    }
    addDamping(E, row, block);
    invertFree(block, free, inverse + static_cast<std::size_t>(row) * N * N);
  }
};

// Copies the blocks of Z at the added nodes.
template <int N>
struct KeepBlock
{
  int const* diagonal; // of MatrixGraph
  Cycle::Dofs added;
  float const* A;
  float* kept; // (nodes, N, N)
  KOKKOS_FUNCTION void operator()(int node) const
  {
    const int row = added(node, 0) / N;
    for (int i = 0; i < N * N; ++i) {
      kept[static_cast<std::size_t>(node) * N * N + i] =
        A[static_cast<std::size_t>(diagonal[row]) * N * N + i];
    }
  }
};

// The same at an added node, whose block of H counts, and is added to Z in the matrix.
template <int N>
struct InvertAdded
{
  InvertFinest<N> finest;
  Cycle::Dofs added;
  HessianView H;
  ConstFlagView removed;
  float const* Z; // (nodes, N, N) the blocks of Z at these nodes
  float* A;
  KOKKOS_FUNCTION void operator()(int node) const
  {
    const int row = added(node, 0) / N;
    double block[N][N] = {};
    FreeComponents<N> free = {finest.held + row * N, {}};
    for (int s = 0; s < added.extent_int(1); ++s) {
      const int component = added(node, s) % N;
      free.removed[component] = removed(node) != 0;
      for (int t = 0; t < added.extent_int(1); ++t) {
        block[component][added(node, t) % N] = H(node, s, t);
      }
    }
    float const* own = Z + static_cast<std::size_t>(node) * N * N;
    for (int i = 0; i < N * N; ++i) {
      A[static_cast<std::size_t>(finest.diagonal[row]) * N * N + i] =
        own[i] + static_cast<float>(block[i / N][i % N]);
    }
    finest.invert(row, own, block, free);
  }
};
} // namespace asperity::multigrid

#pragma once

#include "portability/Renamed.hpp"

#include <Kokkos_Core.hpp>

namespace asperity::tnnmg::detail
{
// Small dense algebra at one nonlinear node: T x T matrices, T <= 3. Host and device.
constexpr int max_tangents = 3;

struct NodeBlock
{
  double entry[max_tangents][max_tangents] = {};
  int size = 0;

  KOKKOS_FUNCTION explicit NodeBlock(int tangents) : size(tangents) {}

  // Reads the block of `node` from blocks(num_nodes, T, T); store() writes it.
  template <class View>
  KOKKOS_FUNCTION NodeBlock(View const& blocks, int node) : size(static_cast<int>(blocks.extent(1)))
  {
    for (int s = 0; s < size; ++s) {
      for (int t = 0; t < size; ++t) {
        entry[s][t] = blocks(node, s, t);
      }
    }
  }

  template <class View>
  KOKKOS_FUNCTION void store(View const& blocks, int node) const
  {
    for (int s = 0; s < size; ++s) {
      for (int t = 0; t < size; ++t) {
        blocks(node, s, t) = entry[s][t];
      }
    }
  }

  KOKKOS_FUNCTION double trace() const
  {
    double sum = 0;
    for (int t = 0; t < size; ++t) {
      sum += entry[t][t];
    }
    return sum;
  }

  KOKKOS_FUNCTION NodeBlock& operator*=(double factor)
  {
    for (int s = 0; s < size; ++s) {
      for (int t = 0; t < size; ++t) {
        entry[s][t] *= factor;
      }
    }
    return *this;
  }

  KOKKOS_FUNCTION NodeBlock& operator+=(NodeBlock const& other)
  {
    for (int s = 0; s < size; ++s) {
      for (int t = 0; t < size; ++t) {
        entry[s][t] += other.entry[s][t];
      }
    }
    return *this;
  }
};

// Returns the lower triangular L with A = L L^T. A must be symmetric positive definite.
KOKKOS_INLINE_FUNCTION NodeBlock cholesky(NodeBlock const& A)
{
  NodeBlock L(A.size);
  for (int s = 0; s < A.size; ++s) {
    for (int t = 0; t <= s; ++t) {
      double rest = A.entry[s][t];
      for (int k = 0; k < t; ++k) {
        rest -= L.entry[s][k] * L.entry[t][k];
      }
      L.entry[s][t] = s == t ? math::sqrt(rest) : rest / L.entry[t][t];
    }
  }
  return L;
}

// L^-1 for lower triangular L.
KOKKOS_INLINE_FUNCTION NodeBlock inverseOfLower(NodeBlock const& L)
{
  NodeBlock X(L.size);
  for (int column = 0; column < L.size; ++column) {
    for (int s = column; s < L.size; ++s) {
      double rest = s == column ? 1.0 : 0.0;
      for (int k = column; k < s; ++k) {
        rest -= L.entry[s][k] * X.entry[k][column];
      }
      X.entry[s][column] = rest / L.entry[s][s];
    }
  }
  return X;
}

// A^T B
KOKKOS_INLINE_FUNCTION NodeBlock transposedProduct(NodeBlock const& A, NodeBlock const& B)
{
  NodeBlock result(A.size);
  for (int s = 0; s < A.size; ++s) {
    for (int t = 0; t < A.size; ++t) {
      for (int k = 0; k < A.size; ++k) {
        result.entry[s][t] += A.entry[k][s] * B.entry[k][t];
      }
    }
  }
  return result;
}

// Returns A^-1 = L^-T L^-1, where A = L L^T. A must be symmetric positive definite.
KOKKOS_INLINE_FUNCTION NodeBlock inverse(NodeBlock const& A)
{
  const NodeBlock X = inverseOfLower(cholesky(A));
  return transposedProduct(X, X);
}
} // namespace asperity::tnnmg::detail

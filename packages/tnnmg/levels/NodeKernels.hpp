#pragma once

#include "base/Errors.hpp"

#include <cmath>
#include <type_traits>

namespace asperity::tnnmg::detail
{
// Calls work(rows, columns) with the sizes of a block as compile-time constants: 1 to 3 components
// of a fine node, and the 1, 3 or 6 rigid body motions of a coarse one; a body that is periodic in
// one direction has 2 of 3 in the plane and 4 of 6 in space, in two directions 3.
template <class Work>
void withBlockSizes(int rows, int columns, Work const& work)
{
#define ASPERITY_BLOCK_SIZE(R, C)                                                                  \
  if (rows == R && columns == C) {                                                                 \
    return work(std::integral_constant<int, R>(), std::integral_constant<int, C>());               \
  }
  ASPERITY_BLOCK_SIZE(1, 1)
  ASPERITY_BLOCK_SIZE(2, 2)
  ASPERITY_BLOCK_SIZE(3, 3)
  ASPERITY_BLOCK_SIZE(4, 4)
  ASPERITY_BLOCK_SIZE(6, 6)
  ASPERITY_BLOCK_SIZE(2, 3)
  ASPERITY_BLOCK_SIZE(3, 4)
  ASPERITY_BLOCK_SIZE(3, 6)
#undef ASPERITY_BLOCK_SIZE
  ASPERITY_ASSERT(!"a size of blocks that multigrid knows");
}

// sum += sign * a x
template <int R, int C>
inline void addProduct(double sign, float const* a, double const* x, double* sum)
{
  for (int r = 0; r < R; ++r) {
    double product = 0;
    for (int c = 0; c < C; ++c) {
      product += a[r * C + c] * x[c];
    }
    sum[r] += sign * product;
  }
}

// The inverse of a symmetric positive semidefinite block in the components with free(c), zero in
// the others. A component that depends on those before it to single precision counts as not free:
// an aggregate of one or two nodes has fewer motions than a rigid body.
template <int N, class IsFree>
inline void invertFree(double (&a)[N][N], IsFree const& free, float* inverse)
{
  double L[N][N] = {}, X[N][N] = {}; // a = L L^T on what is left, X = L^-1
  bool left[N];
  for (int r = 0; r < N; ++r) {
    left[r] = free(r);
    for (int c = 0; left[r] && c <= r; ++c) {
      double rest = left[c] ? a[r][c] : 0;
      for (int k = 0; k < c; ++k) {
        rest -= L[r][k] * L[c][k];
      }
      if (c < r) {
        L[r][c] = left[c] ? rest / L[c][c] : 0;
      } else {
        left[r] = rest > 1e-5 * a[r][r] && a[r][r] > 0;
        L[r][r] = left[r] ? std::sqrt(rest) : 0;
      }
    }
    if (!left[r]) {
      for (int c = 0; c < r; ++c) {
        L[r][c] = 0;
      }
      continue;
    }
    for (int c = 0; c <= r; ++c) {
      double rest = c == r ? 1 : 0;
      for (int k = c; k < r; ++k) {
        rest -= L[r][k] * X[k][c];
      }
      X[r][c] = rest / L[r][r];
    }
  }
  for (int r = 0; r < N; ++r) {
    for (int c = 0; c < N; ++c) {
      double sum = 0;
      for (int k = 0; k < N; ++k) {
        sum += X[k][r] * X[k][c];
      }
      inverse[r * N + c] = static_cast<float>(sum);
    }
  }
}
} // namespace asperity::tnnmg::detail

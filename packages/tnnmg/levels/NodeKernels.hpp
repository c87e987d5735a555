#pragma once

#include "base/Errors.hpp"

#include <cmath>
#include <cstring>
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

// Four numbers that a processor multiplies at once: compilers do not find this in blocks of three.
using Lanes = float __attribute__((vector_size(16)));

// The first Count of four numbers; the others are zero.
template <int Count>
inline Lanes load(float const* from)
{
  Lanes lanes = {};
  std::memcpy(&lanes, from, sizeof(float) * (Count < 4 ? Count : 4));
  return lanes;
}

template <int Count>
inline void store(Lanes const& lanes, float* to)
{
  std::memcpy(to, &lanes, sizeof(float) * (Count < 4 ? Count : 4));
}

inline float sumOf(Lanes const& lanes) { return (lanes[0] + lanes[2]) + (lanes[1] + lanes[3]); }

// Sums of products of rows with a vector, lane by lane. A row that is followed by another one is
// loaded together with the beginning of that; the lanes of the vector are zero there.
template <int R, int C>
class RowSums
{
public:
  // += a x
  void add(float const* a, float const* x)
  {
    const Lanes low = load<C>(x), high = load < C - 4 < 0 ? 0 : C - 4 > (x + (C > 4 ? 4 : 0));
    addRows(a, low, high, std::integral_constant<int, 0>());
  }
  float operator[](int r) const { return sumOf(sums_[r]); }

private:
  template <int Row>
  void addRows(float const* a, Lanes const& low, Lanes const& high,
               std::integral_constant<int, Row>)
  {
    if constexpr (Row < R) {
      sums_[Row] += load<(R - Row) * C>(a + Row * C) * low;
      if constexpr (C > 4) {
        sums_[Row] += load<(R - Row) * C - 4>(a + Row * C + 4) * high;
      }
      addRows(a, low, high, std::integral_constant<int, Row + 1>());
    }
  }

  Lanes sums_[R] = {};
};

// to = a x with a symmetric a
template <int N>
inline void multiplySymmetric(float const* a, float const (&x)[N], float* to)
{
  Lanes low = {}, high = {};
  for (int c = 0; c < N; ++c) {
    low += load<N>(a + c * N) * x[c];
    if constexpr (N > 4) {
      high += load<N - 4>(a + c * N + 4) * x[c];
    }
  }
  store<N>(low, to);
  if constexpr (N > 4) {
    store<N - 4>(high, to + 4);
  }
}

// to += a^T x
template <int R, int C>
inline void addTransposed(float const* a, float const* x, float* to)
{
  Lanes low = load<C>(to), high = load < C - 4 < 0 ? 0 : C - 4 > (to + (C > 4 ? 4 : 0));
  for (int r = 0; r < R; ++r) {
    low += load<C>(a + r * C) * x[r];
    if constexpr (C > 4) {
      high += load<C - 4>(a + r * C + 4) * x[r];
    }
  }
  store<C>(low, to);
  if constexpr (C > 4) {
    store<C - 4>(high, to + 4);
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

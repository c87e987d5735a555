#pragma once

#include "portability/Renamed.hpp"

#include <Kokkos_Core.hpp>

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace asperity::multigrid
{
// Calls work(rows, columns) with the sizes of a block as compile-time constants: 1 to 3 components
// of a fine node, and the 1, 3 or 6 rigid body motions of a coarse one; a body that is periodic in
// one direction has 2 of 3 in the plane and 4 of 6 in space, in two directions 3. Other sizes are
// an error of the program, std::logic_error.
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
  throw std::logic_error("multigrid: no kernels for blocks of this size");
}

// Products of single blocks. The host takes four numbers at a time: processors multiply so many at
// once, and compilers do not do so with blocks of three. Each thread of a device takes one.
#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__) || defined(__SYCL_DEVICE_ONLY__)

using Lanes = float;
constexpr int num_lanes = 1;
KOKKOS_INLINE_FUNCTION Lanes load(float const* from) { return *from; }
KOKKOS_INLINE_FUNCTION float total(Lanes lane) { return lane; }

// Sums of products of a block's R rows with a vector of C numbers.
template <int R, int C>
class RowSums
{
public:
  // += a x
  KOKKOS_FUNCTION void add(float const* a, float const* x)
  {
    for (int r = 0; r < R; ++r) {
      for (int c = 0; c < C; ++c) {
        sums_[r] += a[r * C + c] * x[c];
      }
    }
  }
  KOKKOS_FUNCTION float operator[](int r) const { return sums_[r]; }

private:
  float sums_[R] = {};
};

// to = a x with a symmetric a
template <int N>
KOKKOS_INLINE_FUNCTION void multiplySymmetric(float const* a, float const (&x)[N], float* to)
{
  for (int r = 0; r < N; ++r) {
    float sum = 0;
    for (int c = 0; c < N; ++c) {
      sum += a[c * N + r] * x[c];
    }
    to[r] = sum;
  }
}

// to += a^T x
template <int R, int C>
KOKKOS_INLINE_FUNCTION void addTransposed(float const* a, float const* x, float* to)
{
  for (int r = 0; r < R; ++r) {
    for (int c = 0; c < C; ++c) {
      to[c] += a[r * C + c] * x[r];
    }
  }
}

#else

using Lanes = float __attribute__((vector_size(16)));
constexpr int num_lanes = 4;

// Loads four numbers: a block's row and what follows it, after the last row the padding of
// makeNumbers().
inline Lanes load(float const* from)
{
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof(lanes));
  return lanes;
}

inline float total(Lanes lanes) { return lanes[0] + lanes[1] + lanes[2] + lanes[3]; }

// The last Count numbers of a block's row. The other lanes are zero but where Count is 3: to make
// the fourth zero would take longer than the rest.
template <int Count>
inline Lanes loadRest(float const* from)
{
  if constexpr (Count == 1) {
    return Lanes{from[0], 0, 0, 0};
  } else if constexpr (Count == 2) {
    return Lanes{from[0], from[1], 0, 0};
  } else {
    return load(from);
  }
}

// A vector of N numbers, N = 1, 2, 3, 4 or 6, in lanes.
template <int N>
struct Packed
{
  static constexpr int num_parts = (N + 3) / 4;
  static constexpr int last = N - 4 * (num_parts - 1); // numbers in the last part
  Lanes part[num_parts] = {};

  static Packed fromArray(float const* from)
  {
    Packed packed;
    for (int k = 0; k + 1 < num_parts; ++k) {
      packed.part[k] = load(from + 4 * k);
    }
    packed.part[num_parts - 1] = loadRest<last>(from + 4 * (num_parts - 1));
    return packed;
  }
  void store(float* to) const
  {
    for (int k = 0; k < num_parts; ++k) {
      std::memcpy(to + 4 * k, &part[k], sizeof(float) * (k + 1 < num_parts ? 4 : last));
    }
  }
};

template <int R, int C>
class RowSums
{
public:
  KOKKOS_FUNCTION void add(float const* a, float const* x)
  {
    const auto packed = Packed<C>::fromArray(x);
    for (int r = 0; r < R; ++r) {
      for (int k = 0; k < Packed<C>::num_parts; ++k) {
        sums_[r] += load(a + r * C + 4 * k) * packed.part[k];
      }
    }
  }
  KOKKOS_FUNCTION float operator[](int r) const
  {
    const float three = sums_[r][0] + sums_[r][1] + sums_[r][2];
    return C == 3 ? three : three + sums_[r][3];
  }

private:
  Lanes sums_[R] = {};
};

template <int N>
KOKKOS_INLINE_FUNCTION void multiplySymmetric(float const* a, float const (&x)[N], float* to)
{
  Packed<N> result;
  for (int c = 0; c < N; ++c) {
    for (int k = 0; k < Packed<N>::num_parts; ++k) {
      result.part[k] += load(a + c * N + 4 * k) * x[c];
    }
  }
  result.store(to);
}

template <int R, int C>
KOKKOS_INLINE_FUNCTION void addTransposed(float const* a, float const* x, float* to)
{
  auto sum = Packed<C>::fromArray(to);
  for (int r = 0; r < R; ++r) {
    for (int k = 0; k < Packed<C>::num_parts; ++k) {
      sum.part[k] += load(a + r * C + 4 * k) * x[r];
    }
  }
  sum.store(to);
}

#endif

struct AllFree
{
  KOKKOS_FUNCTION bool operator()(int) const { return true; }
};

// The inverse of a symmetric positive semidefinite block in the components with free(c), zero in
// the others. A component that depends on those before it to single precision counts as not free:
// an aggregate of one or two nodes has fewer motions than a rigid body.
template <int N, class IsFree>
KOKKOS_INLINE_FUNCTION void invertFree(double (&a)[N][N], IsFree const& free, float* inverse)
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
        L[r][r] = left[r] ? math::sqrt(rest) : 0;
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
} // namespace asperity::multigrid

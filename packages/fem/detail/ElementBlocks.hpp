#pragma once

#include <Kokkos_Core.hpp>

namespace asperity::fem::detail
{
// A coupling of two nodes, Components x Components, row-major. Host and device.
template <int Components>
struct Block
{
  double entry[Components * Components] = {};

  KOKKOS_FUNCTION double& operator()(int i, int j) { return entry[i * Components + j]; }
  KOKKOS_FUNCTION double operator()(int i, int j) const { return entry[i * Components + j]; }
};

template <int Components>
KOKKOS_FUNCTION Block<Components> unitBlock()
{
  Block<Components> block;
  for (int c = 0; c < Components; ++c) {
    block(c, c) = 1;
  }
  return block;
}

// Coupling of two basis functions with the gradients gp and gq [1/m] by an isotropic tensor with
// the Lame constants first and second, per volume: first div div + 2 second eps : eps. Antiplane,
// where Components is 1, second grad . grad.
template <int Dim, int Components>
KOKKOS_FUNCTION Block<Components> isotropicBlock(double const (&gp)[Dim], double const (&gq)[Dim],
                                                 double first, double second)
{
  double dot = 0;
  for (int i = 0; i < Dim; ++i) {
    dot += gp[i] * gq[i];
  }
  Block<Components> block;
  if constexpr (Components == 1) {
    block(0, 0) = second * dot;
  } else {
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < Dim; ++j) {
        block(i, j) = first * gp[i] * gq[j] + second * gp[j] * gq[i];
      }
      block(i, i) += second * dot;
    }
  }
  return block;
}

// F_p block F_q^T, with frames(num_nodes, Components, Components) F of the nodes p and q.
template <int Components, class Frames>
KOKKOS_FUNCTION Block<Components> inFrames(Block<Components> const& block, Frames const& frames,
                                           int p, int q)
{
  Block<Components> half, result;
  for (int i = 0; i < Components; ++i) {
    for (int j = 0; j < Components; ++j) {
      for (int k = 0; k < Components; ++k) {
        half(i, j) += frames(p, i, k) * block(k, j);
      }
    }
  }
  for (int i = 0; i < Components; ++i) {
    for (int j = 0; j < Components; ++j) {
      for (int k = 0; k < Components; ++k) {
        result(i, j) += half(i, k) * frames(q, j, k);
      }
    }
  }
  return result;
}
} // namespace asperity::fem::detail
